#include "tools/view/viewer.h"

#include "libscene/stopwatch.h"
#include "renderer/image.h"
#include "tools/backend_choice.h"
#include "tools/counts_report.h"
#include "tools/grid_report.h"
#include "tools/provenance.h"

#include <atomic>
#include <filesystem>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3d& v) {
  return {v.x, v.y, v.z};
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

} // namespace

Viewer::Viewer(const ViewerSettings& settings)
    : scene_(settings.scene, settings.device == Device::cuda ? Checks::table : Checks::all),
      precision_(settings.precision) {
  // On a GPU the tracer checks records during the upload.
  const Checks checks = settings.device == Device::cuda ? Checks::table : Checks::all;
  for (const std::string& path : settings.grids)
    grids_.push_back(std::make_unique<ViewedGrid>(path, checks, scene_, settings.device));
}

FrameRequest Viewer::frame_request(const PictureRequest& request) const {
  FrameRequest frame;
  frame.tracing.precision = precision_;
  frame.camera = request.camera;
  frame.sampling = request.sampling;
  frame.rules.depth = request.depth;
  if (request.crop) frame.window = window_of(*request.crop, request.camera, request.sampling, "crop");
  return frame;
}

Picture Viewer::picture(const PictureRequest& request, const IsGone& is_gone) const {
  FrameRequest frame_request = this->frame_request(request);
  frame_request.progress = abandoned_when(is_gone);
  const ViewedGrid& grid = this->grid(request.grid);
  Picture picture;
  std::int32_t width = 0, height = 0;
  Stopwatch wait;
  // A frame takes more memory than its bytes: it ends with its turn.
  const std::vector<std::uint8_t> rgb = turns_.run(is_gone, [&] {
    picture.seconds.wait = wait.seconds();
    const Frame frame = grid.tracer.render(frame_request);
    picture.rays = frame.radiance.size();
    picture.seconds.trace = frame.seconds.trace;
    picture.seconds.copy = frame.seconds.download;
    width = image_width(frame, request.sampling);
    height = image_height(frame, request.sampling);
    const Stopwatch rows;
    auto bytes = image_bytes(frame, request.sampling);
    picture.seconds.rows = rows.seconds();
    return bytes;
  });
  const Stopwatch encode;
  picture.jpeg = jpeg(rgb, width, height, request.quality);
  picture.seconds.encode = encode.seconds();
  return picture;
}

Json Viewer::counts(const PictureRequest& request, const IsGone& is_gone) const {
  FrameRequest frame_request = this->frame_request(request);
  frame_request.tracing.count = true;
  frame_request.progress = abandoned_when(is_gone);
  const Frame frame = turns_.run(is_gone, [&] { return grid(request.grid).tracer.render(frame_request); });
  Json json = counts_report(frame.counts);
  json["trace_seconds"] = frame.seconds.trace;
  return json;
}

Json Viewer::description() const {
  const Camera camera = scene_.camera();
  const Boxd bounds = scene_.bounds();
  Json grids = Json::array();
  for (const auto& grid : grids_) {
    const fb::Grid& table = grid->file.table();
    grids.push_back({{"name", file_name(grid->file.path())},
                     {"path", grid->file.path()},
                     {"merge", fb::EnumNameMerge(table.merge())},
                     {"merge_rule", grid->file.is_merged() ? Json(table.merge_rule()->str()) : Json()},
                     {"hash", to_hex(grid->file.hash())},
                     {"bytes", grid->file.bytes()},
                     {"upload_seconds", grid->tracer.upload_seconds()}});
  }
  const bool cuda = !grids_.empty() && grids_.front()->tracer.device() == Device::cuda;
  Json json{{"scene",
             {{"name", file_name(scene_.path())},
              {"path", scene_.path()},
              {"hash", to_hex(scene_.hash())},
              {"primitives", scene_.primitive_count()},
              {"bytes", scene_.bytes()},
              {"bounds", {{"min", vector_json(bounds.min)}, {"max", vector_json(bounds.max)}}}}},
            {"camera",
             {{"from", vector_json(camera.from)},
              {"at", vector_json(camera.at)},
              {"up", vector_json(camera.up)},
              {"angle", camera.angle},
              {"width", camera.width},
              {"height", camera.height}}},
            {"grids", grids},
            {"backend", cuda ? "cuda" : "cpu"},
            {"device", device_name(cuda)},
            {"precision", name_of(resolved(precision_, scene_))}};
  json.update(program_version());
  return json;
}

Json Viewer::statistics(std::size_t grid, const IsGone& is_gone) const {
  ViewedGrid& viewed = *grids_.at(grid);
  return turns_.run(is_gone, [&] { // one at a time
    if (viewed.statistics.is_null())
      viewed.statistics = grid_report(viewed.file, Statistics(viewed.file), true);
    return viewed.statistics;
  });
}

} // namespace masu
