#include "libscene/base/error.h"
#include "page_files.h"
#include "tools/view/http_server.h"
#include "tools/view/viewer.h"

#include <fmt/format.h>

#include <set>

namespace masu {
namespace {

constexpr std::int32_t most_pixels_across = 8192;
constexpr std::size_t most_slice_cells = 200000, most_boxes = 8000;

// Of a request. Every one is to be read: what is left over is unknown.
class Parameters {
public:
  explicit Parameters(const std::map<std::string, std::string>& values) : values_(values) {}

  const std::string* find(const char* name) {
    read_.insert(name);
    const auto found = values_.find(name);
    return found != values_.end() ? &found->second : nullptr;
  }
  const std::string& text(const char* name) {
    const std::string* const value = find(name);
    if (value == nullptr) throw Error(ErrorCode::usage, name, "is missing");
    return *value;
  }
  template <class Number>
  Number number(const char* name, Number least, Number most) {
    const auto number = read_number<Number>(text(name));
    if (!number || !(*number >= least && *number <= most))
      throw Error(ErrorCode::usage, name, fmt::format("isn't a number from {} to {}", least, most));
    return *number;
  }
  Vec3d vector(const char* name) { return parse_vector(name, text(name)); }
  // Throws Error(usage) where one is left over.
  void end() const {
    for (const auto& [name, value] : values_)
      if (!read_.contains(name)) throw Error(ErrorCode::usage, "address", "has an unknown parameter");
  }

private:
  const std::map<std::string, std::string>& values_;
  std::set<std::string> read_;
};

std::size_t grid_of(const Viewer& viewer, Parameters& parameters) {
  return parameters.number<std::size_t>("grid", 0, viewer.grids() + divisions.size() - 1);
}

Camera camera_of(const Viewer& viewer, Parameters& parameters) {
  Camera camera = viewer.scene().camera();
  camera.from = parameters.vector("from");
  camera.at = parameters.vector("at");
  camera.up = parameters.vector("up");
  camera.angle = parameters.number<double>("angle", 0, 180);
  camera.width = parameters.number<std::int32_t>("width", 1, most_pixels_across);
  camera.height = parameters.number<std::int32_t>("height", 1, most_pixels_across);
  if (std::int64_t{camera.width} * camera.height > most_pixels)
    throw Error(ErrorCode::usage, "width", fmt::format("and height make more than {} pixels", most_pixels));
  if (const auto fault = fault_of(camera, camera_places(viewer.scene())))
    throw Error(ErrorCode::usage, fault->part, fault->what);
  return camera;
}

SharePlane plane_of(Parameters& parameters) {
  return {parameters.number<int>("axis", 0, 2), parameters.number<double>("share", 0, 1)};
}

PictureChannel channel_of(Parameters& parameters) {
  for (const auto& [name, channel] : picture_channels())
    if (name == parameters.text("channel")) return channel;
  throw Error(ErrorCode::usage, "channel", "isn't one that pictures have");
}

PictureRequest picture_request(const Viewer& viewer, Parameters& parameters) {
  PictureRequest request;
  request.grid = grid_of(viewer, parameters);
  FrameRequest& frame = request.frame;
  frame.camera = camera_of(viewer, parameters);
  frame.rules.depth = parameters.number<int>("depth", 1, largest_depth);
  request.channel = channel_of(parameters);
  if (request.channel.is_cut) request.cut = plane_of(parameters);
  // moving: soon another one comes. still: the picture that gridrender makes.
  const std::string& quality = parameters.text("quality");
  if (quality != "moving" && quality != "still")
    throw Error(ErrorCode::usage, "quality", "isn't moving or still");
  const bool still = quality == "still";
  frame.sampling = still && request.channel.is_shaded() ? Sampling::corners : Sampling::centers;
  if (const std::string* const crop = parameters.find("crop"))
    frame.window = cropped("crop", *crop, frame.camera, frame.sampling);
  request.quality = still ? JpegQuality{95, true} : JpegQuality{80, false};
  return request;
}

// Of a walk: that of the picture that its ray was picked in.
Precision walk_precision(const Viewer& viewer, Parameters& parameters) {
  const std::string* const name = parameters.find("precision");
  if (name == nullptr) return viewer.precision();
  for (const Precision precision : {Precision::fast, Precision::robust, Precision::doubled})
    if (*name == name_of(precision)) return precision;
  throw Error(ErrorCode::usage, "precision", "isn't fast, robust or double");
}

HttpReply json(const Json& value) {
  return {200, "application/json", json_text(value, -1)};
}

} // namespace

HttpReply answer(const Viewer& viewer, const HttpRequest& request) {
  Parameters parameters(request.parameters);
  if (const std::string* const files = parameters.find("files"); files != nullptr && *files != viewer.files())
    return {409, "application/json", R"({"error": "other files are shown at this address: reload"})"};
  const auto is = [&](const char* path) { return request.path == path; };
  const IsGone& is_gone = request.is_gone;
  std::function<HttpReply()> reply; // once all parameters are read
  if (is("/api/picture")) {
    reply = [&, wanted = picture_request(viewer, parameters)] {
      Picture made = viewer.picture(wanted, is_gone);
      return HttpReply{200, has_values(wanted.channel) ? "application/octet-stream" : "image/jpeg",
                       std::move(made.bytes), timing_of(made)};
    };
  } else if (is("/api/counts")) {
    reply = [&, wanted = picture_request(viewer, parameters)] {
      return json(viewer.counts(wanted, is_gone));
    };
  } else if (is("/api/ray")) {
    const Camera camera = camera_of(viewer, parameters);
    const auto column = parameters.number<std::int32_t>("x", 0, camera.width - 1);
    const auto row = parameters.number<std::int32_t>("y", 0, camera.height - 1);
    reply = [&viewer, camera, column, row] {
      const auto [ray, precision] = viewer.camera_ray(camera, column, row);
      return json({{"origin", ray.origin}, {"direction", ray.direction}, {"precision", name_of(precision)}});
    };
  } else if (is("/api/walk")) {
    const std::size_t grid = grid_of(viewer, parameters);
    const Vec3d origin = parameters.vector("origin"), direction = parameters.vector("direction");
    WalkRequest walked{.ray = unbounded_ray(origin, direction)};
    walked.all_rays = parameters.number<int>("all", 0, 1) == 1;
    walked.rules.depth = parameters.number<int>("depth", 1, largest_depth);
    walked.tracing.precision = walk_precision(viewer, parameters);
    reply = [&, grid, walked] { return json(viewer.walk(grid, walked, is_gone)); };
  } else if (is("/api/slice")) {
    reply = [&, grid = grid_of(viewer, parameters), plane = plane_of(parameters)] {
      return json(viewer.slice(grid, plane, most_slice_cells, is_gone));
    };
  } else if (is("/api/boxes")) {
    const std::size_t grid = grid_of(viewer, parameters);
    std::optional<std::int32_t> depth; // any
    if (parameters.find("depth") != nullptr)
      depth = parameters.number<std::int32_t>("depth", 0, max_hierarchy_depth);
    reply = [&, grid, depth] { return json(viewer.boxes(grid, depth, most_boxes, is_gone)); };
  } else if (is("/api/statistics")) {
    reply = [&, grid = grid_of(viewer, parameters)] { return json(viewer.statistics(grid, is_gone)); };
  } else if (is("/api/scene")) {
    reply = [&viewer] { return json(viewer.description()); };
  }
  parameters.end();
  try {
    if (reply) return reply();
  } catch (const Abandoned&) {
    return {503, "application/json", R"({"error": "too many requests at once"})"};
  }
  const std::string_view path = request.path,
                         name = path == "/" ? "page.html" : path.substr(path.starts_with('/') ? 1 : 0);
  const char* const type = name.ends_with(".html") ? "html" : name.ends_with(".css") ? "css" : "javascript";
  if (const std::string_view text = page_file(name); !text.empty())
    return {200, fmt::format("text/{}; charset=utf-8", type), std::string(text)};
  return {404, "application/json", R"({"error": "there is no such address"})"};
}

} // namespace masu
