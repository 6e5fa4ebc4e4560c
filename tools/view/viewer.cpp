#include "tools/view/viewer.h"

#include "libgrid/statistics/slice.h"
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/base/stopwatch.h"
#include "libscene/plane_cut.h"
#include "renderer/image/image.h"
#include "renderer/view_precision.h"
#include "tools/common/backend.h"
#include "tools/common/color_map.h"
#include "tools/report/counts_report.h"
#include "tools/report/slice_json.h"
#include "tools/report/structure_report.h"
#include "tools/report/walk_text.h"

#include <algorithm>
#include <atomic>
#include <filesystem>

namespace masu {
namespace {

// A colour map in equal steps, as #rrggbb.
Json samples_of(const ColorMap& map) {
  constexpr int samples = 33;
  Json colors = Json::array();
  for (int i = 0; i < samples; ++i) {
    const Rgb& color = map(static_cast<double>(i) / (samples - 1));
    colors.push_back(fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]));
  }
  return colors;
}

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// For FrameRequest::progress, where pictures may take seconds: throws Abandoned from tracing. Looks at the
// connection every 10 ms.
std::function<void(double)> abandoned_when(const IsGone& is_gone) {
  return [&is_gone, watch = Stopwatch(), next = std::make_shared<std::atomic<double>>(0.01)](double) {
    double due = *next;
    if (watch.seconds() < due || !next->compare_exchange_strong(due, watch.seconds() + 0.01)) return;
    if (is_gone()) throw Abandoned();
  };
}

// PictureRows from the top: 8 bits a channel, or values.
struct PictureRows {
  std::int32_t width, height;
  std::vector<std::uint8_t> rgb{};
  std::vector<float> values{};
};

PictureRows shaded(const ResidentTracer& tracer, FrameRequest request, Picture& picture) {
  request.rgb = true;
  const Frame frame = tracer.render(request);
  picture.seconds.trace = frame.seconds.trace;
  picture.seconds.copy = frame.seconds.download;
  const Stopwatch watch;
  const std::int32_t more = rays_beyond_pixels(request.sampling);
  PictureRows rows{frame.columns - more, frame.rows - more, rgb_rows(frame, request.sampling, false)};
  picture.seconds.rows = watch.seconds();
  return rows;
}

PictureRows channel(const ResidentTracer& tracer, const PictureRequest& request, const FrameRequest& frame,
                    Picture& picture) {
  const Channel wanted = *request.channel.channel;
  const Stopwatch trace;
  const Channels channels = trace_channels(tracer, {{wanted}, frame, request.channel.all_rays});
  picture.seconds.trace = trace.seconds(); // with the copy
  picture.warps = channels.warps;
  const Stopwatch watch;
  PictureRows rows{channels.columns, channels.rows};
  if (has_values(request.channel))
    rows.values = channel_values(channels, wanted);
  else
    rows.rgb = channel_bytes(channels, wanted);
  picture.seconds.rows = watch.seconds();
  return rows;
}

// What camera rays meet from the plane on; nothing where they don't meet it.
PictureRows cut(const ResidentTracer& tracer, const SlicePlane& plane, const FrameRequest& frame,
                Picture& picture) {
  const RayWindow window = window_of(frame);
  const CameraRays<double> lattice = camera_rays<double>(frame.camera, frame.sampling, false, window);
  std::vector<Ray<double>> rays(picture.rays);
  parallel_for(static_cast<std::uint64_t>(window.rows), [&](std::size_t row) {
    for (std::int32_t column = 0; column < window.columns; ++column) {
      Ray<double>& ray =
          rays[row * static_cast<std::size_t>(window.columns) + static_cast<std::size_t>(column)];
      ray = camera_ray(lattice, column, static_cast<std::int32_t>(row));
      const double ahead = (plane.position - ray.origin[plane.axis]) / ray.direction[plane.axis];
      ray.t_min = ahead >= 0 ? ahead : ray.t_max;
    }
  });
  std::vector<Vec3f> normals(rays.size());
  const Stopwatch trace;
  tracer.trace(rays, {.normal = reinterpret_cast<float(*)[3]>(normals.data())}, {frame.tracing});
  picture.seconds.trace = trace.seconds();
  const Stopwatch watch;
  PictureRows rows{window.columns, window.rows, lit_bytes(normals, rays)};
  picture.seconds.rows = watch.seconds();
  return rows;
}

} // namespace

Json camera_json(const Camera& camera) {
  return {{"from", camera.from},   {"at", camera.at},       {"up", camera.up},
          {"angle", camera.angle}, {"width", camera.width}, {"height", camera.height}};
}

std::string timing_of(const Picture& picture) {
  const auto& s = picture.seconds;
  std::string text = fmt::format("precision;desc=\"{}\", rays;desc={}", picture.precision, picture.rays);
  if (picture.warps.turns > 0)
    text += fmt::format(", turns;desc={}, busy_lanes;desc={}", picture.warps.turns, picture.warps.busy_lanes);
  for (const auto& [stage, seconds] : {std::pair{"wait", s.wait},
                                       {"trace", s.trace},
                                       {"copy", s.copy},
                                       {"rows", s.rows},
                                       {"encode", s.encode}})
    text += fmt::format(", {};dur={:.3f}", stage, seconds * 1e3);
  return text;
}

Viewer::Viewer(ViewedFiles files, Device device, Precision precision)
    : files_(std::move(files)), device_(device), precision_(precision) {
  for (ViewedStructure& structure : files_.structures)
    grids_.push_back(std::make_unique<ViewedGrid>(std::move(structure), scene(), device));
}

std::string Viewer::files() const {
  std::string all = file_name(files_.path) + to_hex(scene().hash());
  for (const auto& grid : grids_)
    all += file_name(grid->path) + to_hex(grid->file.hash());
  return to_hex(hash_of({reinterpret_cast<const std::uint8_t*>(all.data()), all.size()}));
}

const ViewedGrid& Viewer::grid(std::size_t index, const IsGone& is_gone) const {
  if (index < grids_.size()) return *grids_[index];
  const std::size_t stop = index - grids_.size();
  const std::lock_guard lock(building_);
  std::unique_ptr<ViewedGrid>& grid = divided_.at(stop);
  if (grid == nullptr) {
    const BuildOptions options{.structure = {StructureKind::uniform},
                               .division = parse_division(std::to_string(divisions[stop]))};
    StructureFile file = built_in_memory(scene(), options, abandoned_when(is_gone));
    grid = std::make_unique<ViewedGrid>(ViewedStructure{"", std::move(file)}, scene(), device_);
  }
  return *grid;
}

Picture Viewer::picture(const PictureRequest& request, const IsGone& is_gone) const {
  FrameRequest frame = request.frame;
  frame.tracing.precision = precision_;
  frame.progress = abandoned_when(is_gone);
  Picture picture;
  const RayWindow window = window_of(frame);
  picture.rays = static_cast<std::uint64_t>(window.columns) * static_cast<std::uint64_t>(window.rows);
  const Stopwatch wait;
  // What was traced takes more memory than its bytes: it ends with its turn.
  const PictureRows rows = turns_.run(is_gone, [&] {
    picture.seconds.wait = wait.seconds();
    const ViewedGrid& viewed = grid(request.grid, is_gone);
    const ResidentTracer& tracer = viewed.tracer;
    if (precision_ == Precision::automatic) {
      const ViewPrecision chosen = view_precision(tracer, frame);
      frame.tracing.precision = chosen.precision;
      picture.precision = description_of(chosen);
    } else {
      picture.precision = name_of(precision_);
    }
    if (request.channel.is_cut) {
      const auto& [axis, share] = request.cut;
      return cut(tracer, plane_at_share(finest_layout(viewed.file), axis, share, "share"), frame, picture);
    }
    return request.channel.channel ? channel(tracer, request, frame, picture)
                                   : shaded(tracer, frame, picture);
  });
  const Stopwatch encode;
  const auto* const values = reinterpret_cast<const std::uint8_t*>(rows.values.data());
  const std::vector<std::uint8_t> bytes = has_values(request.channel)
                                              ? deflated({values, rows.values.size() * sizeof(float)}, true)
                                              : jpeg(rows.rgb, rows.width, rows.height, request.quality);
  picture.bytes.assign(bytes.begin(), bytes.end());
  picture.seconds.encode = encode.seconds();
  return picture;
}

Json Viewer::counts(const PictureRequest& request, const IsGone& is_gone) const {
  FrameRequest frame = request.frame;
  frame.tracing.precision = precision_;
  frame.tracing.count = true;
  frame.progress = abandoned_when(is_gone);
  const Frame rendered =
      turns_.run(is_gone, [&] { return grid(request.grid, is_gone).tracer.render(frame); });
  Json json = counts_report(rendered.counts);
  json["trace_seconds"] = rendered.seconds.trace;
  return json;
}

std::pair<Ray<double>, Precision> Viewer::camera_ray(const Camera& camera, std::int32_t column,
                                                     std::int32_t row) const {
  const FrameRequest frame{.tracing = {precision_}, .camera = camera, .sampling = Sampling::centers};
  WalkRequest walk = camera_walk(grids_[0]->tracer, frame, column, row);
  walk.ray.origin = walk.ray.origin + scene().origin();
  return {walk.ray, walk.tracing.precision};
}

Json Viewer::walk(std::size_t grid, WalkRequest request, const IsGone& is_gone) const {
  request.limits = {1000, std::size_t{4} << 20, 10'000'000}; // as JSON some ten times as many bytes
  request.progress = [progress = abandoned_when(is_gone)] { progress(0); };
  return walk_turns_.run(is_gone, [&] {
    const WalkReport report = trace_walk(this->grid(grid, is_gone).tracer, request);
    Json json = walk_json(report);
    for (const WalkRay& ray : report.rays)
      json["ended"].push_back(description_of(ray));
    json["more_rays"] = report.more_rays;
    json["ended_early"] = report.ended_early;
    return json;
  });
}

Json Viewer::slice(std::size_t grid, const SharePlane& wanted, std::size_t most_cells,
                   const IsGone& is_gone) const {
  return turns_.run(is_gone, [&] {
    const StructureFile& file = this->grid(grid, is_gone).file;
    const GridLayout finest = finest_layout(file);
    const int axis = wanted.axis;
    const auto [u, v] = slice_axes(axis);
    const SlicePlane plane = plane_at_share(finest, axis, wanted.share, "share");
    const SliceWindow window = window_of(finest, axis);
    const Vec3d step = voxel_size(finest);
    constexpr std::uint64_t most_in_layer = 1 << 16; // of which empty cells are listed
    const auto in_layer =
        static_cast<std::uint64_t>(finest.division[u]) * static_cast<std::uint64_t>(finest.division[v]);
    const bool without_empty = !file.is_hierarchy() && !file.is_merged() &&
                               in_layer > std::min<std::uint64_t>(most_cells, most_in_layer);
    constexpr std::size_t most_lines = 200000;
    SliceCellsJson made = slice_cells_json(file, plane, window, most_cells, without_empty);
    Json lines = Json::array();
    for (const CutSegment& line : outline_of(scene(), plane, window, 2e-4))
      if (lines.size() < most_lines) lines.push_back({line.from[0], line.from[1], line.to[0], line.to[1]});
    return Json{{"axis", axis},
                {"axes", {u, v}},
                {"position", plane.position},
                {"range", {finest.space.min[axis], finest.space.max[axis]}},
                {"voxels", {finest.division[u], finest.division[v]}},
                {"min", window.min},
                {"step", {step[u], step[v]}},
                {"cells", std::move(made.cells)},
                {"truncated", made.is_truncated},
                {"without_empty", without_empty},
                {"outline", std::move(lines)}};
  });
}

Json Viewer::boxes(std::size_t grid, std::optional<std::int32_t> wanted, std::size_t most,
                   const IsGone& is_gone) const {
  return turns_.run(is_gone, [&] {
    const ViewedGrid& viewed = this->grid(grid, is_gone);
    const StructureFile& file = viewed.file;
    const auto for_each = [&](std::optional<std::int32_t> depth, const auto& act) {
      for_each_box(file, {{}, !depth || !file.is_hierarchy(), {}}, [&](const StructureBox& found) {
        if (!depth || (found.references > 0 ? found.depth <= *depth : found.depth == *depth)) act(found);
      });
    };
    const auto count_of = [&](std::optional<std::int32_t> depth) {
      std::size_t count = 0;
      for_each(depth, [&](const StructureBox&) { ++count; });
      return count;
    };
    std::optional<std::int32_t> depth = wanted;
    const std::size_t count = count_of(depth);
    std::size_t fitting = count;
    if (!depth && file.is_hierarchy())
      for (std::int32_t next = viewed.greatest_depth; fitting > most && next > 0;)
        fitting = count_of(depth = --next);
    const std::size_t step = std::max<std::size_t>(1, (fitting + most - 1) / most);
    Json boxes = Json::array();
    std::size_t index = 0;
    for_each(depth, [&](const StructureBox& found) {
      if (index++ % step == 0)
        boxes.push_back({{"min", found.box.min}, {"max", found.box.max}, {"depth", found.depth}});
    });
    return Json{{"boxes", std::move(boxes)}, {"count", count}, {"depth", depth ? Json(*depth) : Json()}};
  });
}

Json Viewer::description() const {
  Json grids = Json::array();
  for (const auto& grid : grids_) {
    const fb::Structure& table = grid->file.table();
    grids.push_back({{"name", file_name(grid->path)},
                     {"path", grid->path},
                     {"made_by", grid->made_by},
                     {"structure", grid->file.is_hierarchy() ? "bvh" : "grid"},
                     {"greatest_depth", grid->greatest_depth},
                     {"merge", fb::EnumNameMerge(table.merge())},
                     {"merge_rule", grid->file.is_merged() ? Json(table.merge_rule()->str()) : Json()},
                     {"hash", to_hex(grid->file.hash())},
                     {"bytes", grid->file.bytes()},
                     {"upload_seconds", grid->tracer.upload_seconds()}});
  }
  Json channels = Json::array();
  for (const auto& [name, channel] : picture_channels())
    channels.push_back(name);
  const bool cuda = !grids_.empty() && grids_.front()->tracer.device() == Device::cuda;
  Json json{{"scene",
             {{"name", file_name(files_.path)},
              {"path", files_.path},
              {"made_by", files_.made_by},
              {"hash", to_hex(scene().hash())},
              {"primitives", scene().primitive_count()},
              {"bytes", scene().bytes()},
              {"bounds", in_world(scene().origin(), scene().bounds())}}},
            {"camera", camera_json(scene().camera())},
            {"grids", grids},
            {"divisions", divisions},
            {"channels", channels},
            {"colors", samples_of(ColorMap())},
            {"list_colors", samples_of(ColorMap::of_lists())},
            {"backend", cuda ? "cuda" : "cpu"},
            {"device", device_name(cuda)},
            {"precision", name_of(precision_)},
            {"files", files()}};
  json.update(program_version());
  return json;
}

Json Viewer::statistics(std::size_t grid, const IsGone& is_gone) const {
  return turns_.run(is_gone, [&] { // one at a time
    const ViewedGrid& viewed = this->grid(grid, is_gone);
    if (viewed.statistics.is_null()) viewed.statistics = structure_report(viewed.file, true);
    return viewed.statistics;
  });
}

} // namespace masu
