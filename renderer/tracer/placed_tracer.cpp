#include "renderer/tracer/placed_tracer.h"

#include "libscene/base/error.h"
#include "libscene/base/on_threads.h"
#include "libscene/cuda/cuda_device.h"
#include "libscene/cuda/host_copies.h"
#include "renderer/backend.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace masu {

PlacedTracer::PlacedTracer(std::shared_ptr<const PlacedScene> scene, HierarchyQuality quality,
                           bool is_brute_force, std::vector<int> gpus,
                           const std::function<void(double)>& progress)
    : scene_(std::move(scene)), gpus_(std::move(gpus)), files_(gpus_.size()),
      turn_(std::make_shared<std::atomic<std::size_t>>(0)) {
  ProgressMonitor monitor(progress);
  host_ = std::make_shared<const AnyPlacedOnHost>(placed_on_host(scene_, quality, is_brute_force, &monitor));
  on_threads(gpus_.size(), [&](std::size_t i) {
    set_up_cuda(gpus_[i]);
    files_[i] = upload_placed_cuda(*host_, gpus_[i]);
  });
}

PlacedTracer PlacedTracer::moved(const PlacementMoves& moves) const {
  if (moves.indices == nullptr && moves.count != scene_->count())
    fail("placements", fmt::format("are {}, the scene has {}", moves.count, scene_->count()));
  PlacedTracer tracer = *this;
  on_threads(files_.size(), [&](std::size_t i) { tracer.files_[i] = placed_files_cuda(*files_[i], moves); });
  if (!gpus_.empty()) return tracer;
  HostCopies copies;
  PlacementMoves here = moves;
  here.indices = copies.of(moves.indices, moves.count);
  here.floats = copies.of(moves.floats, moves.count * moves.numbers());
  here.doubles = copies.of(moves.doubles, moves.count * moves.numbers());
  tracer.host_ = std::make_shared<const AnyPlacedOnHost>(masu::moved(*host_, here));
  return tracer;
}

RaysRequest PlacedTracer::resolved(const RayList& rays, const RayResults& results,
                                   const RaysRequest& request) const {
  RaysRequest resolved = request;
  resolved.tracing.precision = masu::resolved(request.tracing.precision, *scene_->meshes);
  if (resolved.tracing.precision == Precision::fast)
    fail("precision", "fast isn't there for placed meshes: take robust or double");
  if (request.tracing.count || results.costs.wanted()) fail("rays", "through placed meshes can't be counted");
  RayList checked = rays;
  if (rays.filters.object_masks == nullptr) checked.filters.ray_masks = nullptr; // placements have their own
  check_query(checked, results, resolved, scene_->objects());
  if ((rays.filters.excluded != nullptr) != (rays.filters.excluded_objects != nullptr))
    fail("exclude", "needs the objects of its primitives, too: placements");
  return resolved;
}

// Alike rays begin as packets (libgrid/placed/placed_packet.h). Among thousands of placements neighbours soon
// go different ways, and idle lanes are worth more than that.
RayLoop PlacedTracer::usual_loop(bool coherent) const {
  constexpr std::uint32_t few = 256;
  if (scene_->count() / std::max(scene_->world_count, 1U) >= few) return RayLoop::warp_refill;
  return coherent ? RayLoop::thread_per_ray : RayLoop::automatic;
}

QueryReport PlacedTracer::trace(const RayList& rays, const RayResults& results,
                                const RaysRequest& request) const {
  const RaysRequest checked = resolved(rays, results, request);
  const RayList local = relative_to(scene_->origin(), rays);
  if (gpus_.empty()) return trace_placed_cpu(*host_, local, results, checked);
  const std::span all(files_);
  return trace_by_gpus(rays.count <= rays_per_piece(request)
                           ? all.subspan(turn_->fetch_add(1, std::memory_order_relaxed) % all.size(), 1)
                           : all,
                       local, results, checked);
}

QueryReport PlacedTracer::trace_on_device(const RayList& rays, const RayResults& results,
                                          const RaysRequest& request, void* stream, int gpu) const {
  const auto index = static_cast<std::size_t>(std::ranges::find(gpus_, gpu) - gpus_.begin());
  return launch_rays_cuda(*files_.at(index), relative_to(scene_->origin(), rays), results,
                          resolved(rays, results, request), stream);
}

} // namespace masu
