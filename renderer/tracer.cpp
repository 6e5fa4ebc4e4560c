#include "renderer/tracer.h"

#include "libscene/base/error.h"
#include "libscene/base/on_threads.h"
#include "libscene/base/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"
#include "renderer/image/pixel.h"
#include "renderer/picture_warps.h"
#include "renderer/view_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace masu {
namespace {

// Whether `count` from `first` on lie below `end`, and are at least one.
bool is_within(std::int32_t first, std::int32_t count, std::int32_t end) {
  return first >= 0 && count > 0 && first < end && count <= end - first;
}

void check_window(const RayWindow& window, const RayWindow& all) {
  if (!is_within(window.first_column, window.columns, all.columns) ||
      !is_within(window.first_row, window.rows, all.rows))
    throw Error(ErrorCode::usage, "window",
                fmt::format("{} x {} rays from column {}, row {} aren't within the picture's {} x {}",
                            window.columns, window.rows, window.first_column, window.first_row, all.columns,
                            all.rows));
}

} // namespace

void check_depth(std::int32_t depth) {
  if (depth < 1 || depth > largest_depth)
    throw Error(ErrorCode::usage, "depth", fmt::format("{} isn't from 1 to {}", depth, largest_depth));
}

void check_request(const FrameRequest& request) {
  check_depth(request.rules.depth);
  if (request.attributes && !(request.hits && request.rules.hit_name == HitName::primitive))
    throw Error(ErrorCode::usage, "attributes", "need hits that are named by primitive");
  if (request.window.columns > 0) check_window(request.window, all_rays(request.camera, request.sampling));
}

RayWindow window_of(const FrameRequest& request) {
  return request.window.columns > 0 ? request.window : all_rays(request.camera, request.sampling);
}

Frame sized_frame(const FrameRequest& request, Frame memory) {
  Frame frame;
  for_each_array(frame, memory, [](auto& array, auto& spare) { array = std::move(spare); });
  const RayWindow window = window_of(request);
  frame.columns = window.columns;
  frame.rows = window.rows;
  const std::size_t rays = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  frame.radiance.resize(request.shaded && !request.rgb ? rays : 0);
  const std::int32_t more = rays_beyond_pixels(request.sampling);
  frame.rgb.resize(request.rgb ? 3 * static_cast<std::size_t>(frame.columns - more) *
                                     static_cast<std::size_t>(frame.rows - more)
                               : 0);
  frame.hits.resize(request.hits ? rays : 0);
  frame.objects.resize(request.attributes ? rays : 0);
  frame.normals.resize(request.attributes ? rays : 0);
  frame.cells.resize(request.costs ? rays : 0);
  frame.tests.resize(request.costs ? rays : 0);
  return frame;
}

Tracer::Tracer(const SceneFile& scene, const StructureFile* grid, Device device, std::vector<int> gpus)
    : scene_(scene), grid_(grid), device_(device),
      gpus_(device == Device::cuda ? std::move(gpus) : std::vector<int>()),
      turn_(std::make_shared<std::atomic<std::size_t>>(0)) {
  if (device == Device::cuda && gpus_.empty()) throw Error(ErrorCode::usage, "gpus", "none is named");
  const auto stays_in_file = [](const auto& file) { return file.residence() == Residence::file; };
  if (device == Device::cpu && (stays_in_file(scene) || (grid != nullptr && stays_in_file(*grid))))
    throw Error(ErrorCode::usage, scene.path(), "isn't in memory: open it for a CPU");
  if (grid != nullptr) grid->check_geometry(scene.geometry_hash(), scene.primitive_count());
  on_threads(gpus_.size(), [&](std::size_t i) { set_up_cuda(gpus_[i]); });
  const Stopwatch watch;
  files_.resize(gpus_.size());
  on_threads(gpus_.size(), [&](std::size_t i) { files_[i] = upload_files_cuda(scene, grid, gpus_[i]); });
  upload_seconds_ = watch.seconds();
  kinds_ = device == Device::cuda ? kinds_on(*files_.front())
                                  : scene.with_view([](const auto& view) { return kinds_in(view); });
}

void Tracer::check_unchanged() const {
  scene_.check_unchanged();
  if (grid_ != nullptr) grid_->check_unchanged();
}

TracingRules Tracer::resolved(TracingRules rules) const {
  rules.precision = masu::resolved(rules.precision, scene_);
  rules.kinds = kinds_;
  if (rules.stop == StopRule::first_cell && grid_ != nullptr && grid_->is_hierarchy())
    throw Error(ErrorCode::usage, "first-cell-hit", "needs a grid of cells: a hierarchy has none");
  return rules;
}

Frame Tracer::render(const FrameRequest& request, std::size_t index, Frame memory) const {
  check_request(request);
  FrameRequest resolved_request = request;
  resolved_request.tracing.precision = picture_precision(*this, request);
  resolved_request.tracing = resolved(resolved_request.tracing);
  resolved_request.camera = relative_to(scene_.origin(), request.camera);
  if (request.costs) resolved_request.tracing.count = true;
  if (!request.shaded) resolved_request.rules.depth = 0;
  resolved_request.rgb = request.rgb && request.shaded && device_ == Device::cuda;
  Frame frame = sized_frame(resolved_request, std::move(memory));
  device_ == Device::cuda ? render_cuda(*files_.at(index), resolved_request, frame)
                          : render_cpu(scene_, grid_, resolved_request, frame);
  check_unchanged();
  return frame;
}

Frame Tracer::render(const FrameRequest& wanted) const {
  constexpr std::int64_t rays_per_band = std::int64_t{1} << 20;
  const RayWindow window = window_of(wanted);
  const auto band_rows = static_cast<std::int32_t>( // of whole tiles
      std::max<std::int64_t>(rays_per_band / std::max(window.columns, 1) / tile_side, 1) * tile_side);
  if (device_count() == 1 || window.rows <= band_rows) return render(wanted, next_device());
  FrameRequest request = wanted;
  request.rgb = false; // bands share rows of corners, not of pixels
  check_window(window, all_rays(request.camera, request.sampling)); // before there is room for it
  const Precision precision = picture_precision(*this, request);
  Frame whole = sized_frame(request);
  std::mutex mutex;
  std::atomic<std::int32_t> next_row = 0;
  on_threads(device_count() * queries_per_gpu, [&](std::size_t worker) {
    Frame band;
    for (std::int32_t row; (row = next_row.fetch_add(band_rows)) < window.rows;) {
      FrameRequest part = request;
      part.tracing.precision = precision;
      part.window = {window.first_column, window.first_row + row, window.columns,
                     std::min(band_rows, window.rows - row)};
      part.count_last_row = request.count_last_row || row + part.window.rows < window.rows;
      band = render(part, worker % device_count(), std::move(band));
      const auto first = static_cast<std::ptrdiff_t>(row) * window.columns;
      for_each_array(band, whole, [&](const auto& from, auto& to) {
        if (!from.empty()) std::ranges::copy(from, to.begin() + first);
      });
      const std::lock_guard lock(mutex);
      whole.counts += band.counts;
      whole.seconds += band.seconds;
      whole.kernel = band.kernel;
    }
  });
  return whole;
}

// Small queries take turns.
std::size_t Tracer::next_device() const {
  return device_count() > 1 ? turn_->fetch_add(1, std::memory_order_relaxed) % device_count() : 0;
}

} // namespace masu
