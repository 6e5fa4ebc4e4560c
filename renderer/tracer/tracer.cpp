#include "renderer/tracer/tracer.h"

#include "libscene/base/error.h"
#include "libscene/base/on_threads.h"
#include "libscene/base/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"
#include "renderer/picture_warps.h"
#include "renderer/view_precision.h"

#include <algorithm>
#include <mutex>

namespace masu {

ResidentTracer::ResidentTracer(const SceneFile& scene, const StructureFile* structure, Device device,
                               std::vector<int> gpus)
    : ResidentTracer(scene, structure, device, std::move(gpus),
                     [&](int gpu) { return upload_files_cuda(scene, structure, gpu); }) {}

ResidentTracer::ResidentTracer(const SceneFile& scene, const StructureFile* structure, Device device,
                               std::vector<int> gpus, const Upload& upload,
                               const std::function<void()>& meanwhile)
    : scene_(scene), structure_(structure), is_hierarchy_(structure != nullptr && structure->is_hierarchy()),
      device_(device), gpus_(device == Device::cuda ? std::move(gpus) : std::vector<int>()),
      turn_(std::make_shared<std::atomic<std::size_t>>(0)) {
  if (device == Device::cuda && gpus_.empty()) throw Error(ErrorCode::usage, "gpus", "none is named");
  const auto stays_in_file = [](const auto& file) { return file.residence() == Residence::file; };
  if (device == Device::cpu && (stays_in_file(scene) || (structure != nullptr && stays_in_file(*structure))))
    throw Error(ErrorCode::usage, scene.path(), "isn't in memory: open it for a CPU");
  if (structure != nullptr) structure->check_geometry(scene.geometry_hash(), scene.primitive_count());
  on_threads(gpus_.size(), [&](std::size_t i) { set_up_cuda(gpus_[i]); });
  const Stopwatch watch;
  files_.resize(gpus_.size());
  on_threads(
      gpus_.size(), [&](std::size_t i) { files_[i] = upload(gpus_[i]); }, meanwhile);
  upload_seconds_ = watch.seconds();
  kinds_ =
      device == Device::cuda
          ? kinds_on(*files_.front())
          : scene.with_view([]<class Stored>(const SceneView<Stored>& view) {
              return kinds_in(view, std::any_of(view.cones, view.cones + view.cone_count, tapers<Stored>));
            });
}

void ResidentTracer::check_unchanged() const {
  scene_.check_unchanged();
  if (structure_ != nullptr) structure_->check_unchanged();
}

TracingRules ResidentTracer::resolved(TracingRules rules) const {
  rules.precision = masu::resolved(rules.precision, scene_);
  rules.kinds = kinds_;
  if (rules.stop == StopRule::first_cell && is_hierarchy_)
    throw Error(ErrorCode::usage, "first-cell-hit", "needs a grid of cells: a hierarchy has none");
  return rules;
}

Frame ResidentTracer::render(const FrameRequest& request, std::size_t index, Frame memory) const {
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
                          : render_cpu(scene_, structure_, resolved_request, frame);
  check_unchanged();
  return frame;
}

Frame ResidentTracer::render(const FrameRequest& wanted) const {
  constexpr std::int64_t rays_per_band = std::int64_t{1} << 20;
  const RayWindow window = window_of(wanted);
  const auto band_rows = static_cast<std::int32_t>( // of whole tiles
      std::max<std::int64_t>(rays_per_band / std::max(window.columns, 1) / tile_side, 1) * tile_side);
  if (device_count() == 1 || window.rows <= band_rows) return render(wanted, next_device());
  FrameRequest request = wanted;
  request.rgb = false;    // bands share rows of corners, not of pixels
  check_request(request); // before there is room for it
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
std::size_t ResidentTracer::next_device() const {
  return device_count() > 1 ? turn_->fetch_add(1, std::memory_order_relaxed) % device_count() : 0;
}

} // namespace masu
