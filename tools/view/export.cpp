#include "tools/view/export.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "page_files.h"
#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/common/vector_json.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array slice_shares{0.1, 0.3, 0.5, 0.7, 0.9};
constexpr std::size_t most_slice_cells = 10000, most_boxes = 1000;

bool is_gone() {
  return false;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

// Whether the channel's picture is another one for each grid.
bool depends_on_grid(const PictureChannel& channel) {
  return channel.channel == Channel::cells || channel.channel == Channel::tests;
}

Json picture_json(const Picture& picture) {
  const PictureSeconds& s = picture.seconds;
  Json json{{"precision", picture.precision},
            {"image", "data:image/jpeg;base64," + base64(picture.jpeg)},
            {"rays", picture.rays},
            {"milliseconds",
             {{"wait", 0},
              {"trace", s.trace * 1e3},
              {"copy", s.copy * 1e3},
              {"rows", s.rows * 1e3},
              {"encode", s.encode * 1e3}}}};
  if (picture.range) json["range"] = *picture.range;
  return json;
}

// All pictures of a view: {channel: [one a grid]}. Ranges of colours are those of all grids.
Json channels_json(const Viewer& viewer, PictureRequest request) {
  Json all;
  for (const std::string& name : picture_channel_names()) {
    request.channel = parse_picture_channel(name);
    request.sampling = request.channel.channel ? Sampling::centers : Sampling::corners;
    request.range.reset();
    std::vector<Picture> pictures;
    const auto trace = [&] {
      pictures.clear();
      for (request.grid = 0; request.grid < viewer.grids(); ++request.grid)
        pictures.push_back(viewer.picture(request, is_gone));
    };
    trace();
    if (pictures.front().range && viewer.grids() > 1 && depends_on_grid(request.channel)) {
      request.range = pictures.front().range;
      for (const Picture& picture : pictures)
        (*request.range)[1] = std::max((*request.range)[1], (*picture.range)[1]);
      trace();
      for (Picture& picture : pictures)
        picture.range = request.range;
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      Json json = picture_json(pictures[i]);
      if (i > 0 && !depends_on_grid(request.channel)) json.erase("image"); // the first grid's
      all[name].push_back(std::move(json));
    }
  }
  return all;
}

Json view_json(const Viewer& viewer, const ExportSettings& settings, const Camera& camera) {
  PictureRequest request;
  request.camera = camera;
  request.quality = {85, true};
  Json json{{"camera",
             {{"from", vector_json(camera.from)},
              {"at", vector_json(camera.at)},
              {"up", vector_json(camera.up)},
              {"angle", camera.angle}}},
            {"channels", channels_json(viewer, request)}};
  const auto [ray, precision] = viewer.camera_ray(camera, settings.width / 2, settings.height / 2);
  for (request.grid = 0; request.grid < viewer.grids(); ++request.grid) {
    json["counts"].push_back(viewer.counts(request, is_gone));
    json["walks"].push_back(
        viewer.walk({request.grid, ray.origin, ray.direction, false, 5, precision}, is_gone));
  }
  return json;
}

Json data_of(const Viewer& viewer, const ExportSettings& settings,
             const std::function<void(double)>& progress) {
  Camera camera = viewer.scene().camera();
  camera.width = settings.width;
  camera.height = settings.height;
  Json data{
      {"scene", viewer.description()}, {"size", {settings.width, settings.height}}, {"shares", slice_shares}};
  for (std::size_t grid = 0; grid < viewer.grids(); ++grid) {
    data["statistics"].push_back(viewer.statistics(grid, is_gone));
    Json slices = Json::array();
    for (int axis = 0; axis < 3; ++axis) {
      for (const double share : slice_shares)
        slices.push_back(viewer.slice({grid, axis, share, most_slice_cells}, is_gone));
    }
    data["slices"].push_back(std::move(slices));
    Json boxes = Json::array();
    boxes.push_back(viewer.boxes({grid, {}, most_boxes}, is_gone)); // of any depth, then of each
    for (std::int32_t depth = 0; depth <= viewer.grid(grid).greatest_depth; ++depth)
      boxes.push_back(viewer.boxes({grid, depth, most_boxes}, is_gone));
    data["boxes"].push_back(std::move(boxes));
  }
  const std::vector<View> views = turntable(camera, settings.views);
  for (std::size_t i = 0; i < views.size(); ++i) {
    data["views"].push_back(view_json(viewer, settings, views[i].camera));
    progress(static_cast<double>(i + 1) / static_cast<double>(views.size()));
  }
  data.update(provenance());
  return data;
}

std::string_view page_file(std::string_view wanted) {
  for (const auto& [name, text] : page_files) {
    if (name == wanted) return text;
  }
  throw Error(ErrorCode::output, std::string(wanted), "isn't part of the program");
}

// Replaces what stands from `begin` to `end`, both included.
void replace(std::string& text, std::string_view begin, std::string_view end, const std::string& by) {
  const std::size_t first = text.find(begin), last = text.find(end, first);
  if (first == std::string::npos || last == std::string::npos)
    throw Error(ErrorCode::output, "page", fmt::format("has no {}", begin));
  text.replace(first, last + end.size() - first, by);
}

} // namespace

void export_page(const Viewer& viewer, const ExportSettings& settings,
                 const std::function<void(double)>& progress) {
  std::string data = json_text(data_of(viewer, settings, progress), -1);
  // No text may be taken for markup that ends the script or hides its end (</script>, <!--<script>).
  for (std::size_t at = 0; (at = data.find('<', at)) != std::string::npos; ++at)
    data.replace(at, 1, "\\u003c");
  std::string scripts = "<script>const EXPORTED = " + data + ";</script>\n";
  std::string page(page_file("page.html"));
  for (const auto& [name, text] : page_files) {
    if (!name.ends_with(".js")) continue;
    scripts += fmt::format("<script>\n{}</script>\n", text);
    replace(page, fmt::format("<script defer src=\"{}\">", name), "</script>\n", "");
  }
  // Nothing is loaded from anywhere.
  replace(
      page, "<meta charset", ">",
      "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">");
  replace(page, "<link rel=\"stylesheet\"", ">", fmt::format("<style>\n{}</style>", page_file("page.css")));
  replace(page, "</body>", "</body>", scripts + "</body>");
  OutputFile file(settings.path);
  file.write(page.data(), page.size());
  file.commit();
}

} // namespace masu
