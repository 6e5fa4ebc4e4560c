// A tracer's queries of lists of rays, and tracers whose hierarchy GPUs have built, or fitted to a scene that
// has moved: who doesn't call them doesn't link them.
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/error.h"
#include "libscene/base/on_threads.h"
#include "renderer/backend.h"
#include "renderer/rays/closest_points.h"
#include "renderer/tracer/tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace masu {
namespace {

// Rounded to the arithmetic's numbers, in memory of the device, and their results behind them.
template <class Real>
ResidentRays resident_rays(std::span<const Ray<double>> rays, const std::vector<int>& gpus) {
  const std::size_t count = rays.size(), ray_bytes = count * sizeof(Ray<Real>),
                    result_bytes = sizeof(float) + sizeof(std::uint32_t) + sizeof(std::uint8_t);
  const auto block = std::make_shared<HostBytes>(ray_bytes + count * result_bytes);
  for (std::size_t i = 0; i < count; ++i)
    reinterpret_cast<Ray<Real>*>(block->data())[i] = loaded<Real>(rays.data(), own_format<double>, i);
  const std::shared_ptr<std::uint8_t> memory = gpus.empty()
                                                   ? std::shared_ptr<std::uint8_t>(block, block->data())
                                                   : uploaded_cuda(*block, gpus.front());
  ResidentRays resident{relative(RayList(memory.get(), count, own_format<Real>)), {}, memory};
  resident.results.t = reinterpret_cast<float*>(memory.get() + ray_bytes);
  resident.results.primitive = reinterpret_cast<std::uint32_t*>(resident.results.t + count);
  resident.results.occluded = reinterpret_cast<std::uint8_t*>(resident.results.primitive + count);
  return resident;
}

void check_results(const RayList& rays, const RayResults& results, Query query) {
  if (rays.count == 0) return;
  if (rays.rays == nullptr) fail("rays", "are missing: the pointer is null");
  const std::size_t number = rays.format.is_float64 ? sizeof(double) : sizeof(float);
  if (reinterpret_cast<std::uintptr_t>(rays.rays) % number != 0)
    fail("rays", "aren't aligned as their numbers must be");
  const bool are_places = query == Query::closest_point && rays.format.numbers == 3;
  if (!are_places && rays.format.numbers != 6 && rays.format.numbers != 8)
    fail("rays", "have 6 or 8 numbers each");
  if (query == Query::occlusion && results.occluded == nullptr)
    fail("rays", "have no array for whether they are occluded");
}

void check_hits_in_order(const RaysRequest& request, const RayResults& results) {
  if (request.query == Query::all_hits && (request.limit < 1 || request.limit > max_hits_per_ray))
    fail("limit", fmt::format("{} hits per ray aren't from 1 to {}", request.limit, max_hits_per_ray));
  if (request.tracing.precision == Precision::fast)
    fail("precision", "fast finds nearest hits and occlusion alone, of both faces: take robust or double");
  if (request.tracing.stop == StopRule::first_cell)
    fail("first-cell-hit", "is for nearest hits and occlusion alone, of both faces");
  if (request.tracing.count || results.costs.wanted())
    fail("rays", "can't be counted where their hits are found in order");
}

void check_filters(const RayFilters& filters, std::uint64_t objects) {
  if (filters.object_masks == nullptr) {
    if (filters.ray_masks != nullptr) fail("ray_masks", "have no effect without those of objects: give both");
  } else if (filters.object_count != objects) {
    fail("object_masks",
         fmt::format("are for {} objects, and the scene has {}", filters.object_count, objects));
  }
}

} // namespace

void check_closest(const Boxd& bounds) {
  if (!is_empty(bounds) && largest_magnitude(bounds) > max_closest)
    fail("scene", "has coordinates beyond 1e37, too large for distances");
}

void check_query(const RayList& rays, const RayResults& results, const RaysRequest& request,
                 std::uint64_t objects) {
  check_results(rays, results, request.query);
  check_filters(rays.filters, objects);
  if (needs_hits_in_order(rays, results, request)) check_hits_in_order(request, results);
}

QueryReport trace_by_gpus(std::span<const std::shared_ptr<const DeviceFiles>> files, const RayList& rays,
                          const RayResults& results, const RaysRequest& request) {
  std::atomic<std::size_t> next_piece = 0;
  if (files.size() == 1) return trace_rays_cuda(*files.front(), rays, results, request, next_piece);
  std::mutex mutex;
  QueryReport all;
  const auto trace_pieces = [&](std::size_t index) {
    const QueryReport report = trace_rays_cuda(*files[index], rays, results, request, next_piece);
    const std::lock_guard lock(mutex);
    all.counts += report.counts;
    all.seconds += report.seconds;
    all.kernel = report.kernel;
  };
  const auto meanwhile = [&] {
    if (request.progress) request.progress(share_of_pieces(next_piece, rays, request));
  };
  on_threads(files.size(), trace_pieces, meanwhile);
  return all;
}

RaysRequest ResidentTracer::resolved(const RaysRequest& request, const RayList& rays,
                                     const RayResults& results) const {
  RaysRequest resolved_request = request;
  resolved_request.tracing = resolved(request.tracing);
  check_query(rays, results, resolved_request, scene_.counts().objects);
  if (rays.filters.any_of_placed())
    fail("rays", "have worlds or excluded objects: the scene has no placements");
  if (request.query == Query::closest_point) {
    if (structure_ != nullptr && !structure_->is_hierarchy())
      fail("structure", "is a grid: closest points are found through a hierarchy");
    check_closest(scene_.bounds());
  }
  if (results.costs.wanted()) resolved_request.tracing.count = true;
  return resolved_request;
}

QueryReport ResidentTracer::trace(const RayList& rays, const RayResults& results, const RaysRequest& request,
                                  std::size_t index) const {
  const RaysRequest resolved_request = resolved(request, rays, results);
  if (device_ == Device::cpu) {
    const QueryReport report =
        trace_rays_cpu(scene_, structure_, relative_to(scene_.origin(), rays), results, resolved_request);
    check_unchanged();
    return report;
  }
  return trace_by_gpus(std::span(files_).subspan(index, 1), relative_to(scene_.origin(), rays), results,
                       resolved_request);
}

QueryReport ResidentTracer::trace(const RayList& rays, const RayResults& results,
                                  const RaysRequest& request) const {
  if (device_count() == 1 || rays.count <= rays_per_piece(request))
    return trace(rays, results, request, next_device());
  return trace_by_gpus(files_, relative_to(scene_.origin(), rays), results, resolved(request, rays, results));
}

QueryReport ResidentTracer::trace_on_device(const RayList& rays, const RayResults& results,
                                            const RaysRequest& request, void* stream, int gpu) const {
  if (device_ == Device::cpu) return trace(rays, results, request);
  const auto index = static_cast<std::size_t>(std::ranges::find(gpus_, gpu) - gpus_.begin());
  if (index == gpus_.size()) fail("rays", "aren't in memory of the tracer's GPUs");
  const RaysRequest resolved_request = resolved(request, rays, results);
  if (resolved_request.tracing.count) fail("rays", "in device memory can't be counted");
  return launch_rays_cuda(*files_[index], relative_to(scene_.origin(), rays), results, resolved_request,
                          stream);
}

RayHits ResidentTracer::hits(const RayList& rays, const RaysRequest& request, HitName name) const {
  std::vector<float> t(rays.count);
  std::vector<std::uint32_t> names(rays.count);
  std::vector<std::uint8_t> occluded(request.query == Query::occlusion ? rays.count : 0);
  RayResults results;
  results.t = t.data();
  (name == HitName::object      ? results.object
   : name == HitName::primitive ? results.primitive
                                : results.face) = names.data();
  results.occluded = occluded.data();
  RayHits found{std::vector<HitRecord>(rays.count), trace(rays, results, request)};
  for (std::size_t i = 0; i < rays.count; ++i)
    found.hits[i] = request.query == Query::occlusion ? HitRecord{1, occluded[i] != 0 ? 0 : -1}
                                                      : HitRecord{t[i], static_cast<std::int32_t>(names[i])};
  return found;
}

ResidentRays ResidentTracer::upload(std::span<const Ray<double>> rays, Precision precision) const {
  precision = masu::resolved(precision, scene_);
  return precision == Precision::doubled ? resident_rays<double>(rays, gpus_)
                                         : resident_rays<float>(rays, gpus_);
}

QueryReport ResidentTracer::trace(const ResidentRays& rays, const RaysRequest& request) const {
  if (device_ == Device::cpu) return trace(rays.list, rays.results, request);
  return time_rays_cuda(*files_.front(), rays, resolved(request, rays.list, rays.results));
}

ResidentTracer ResidentTracer::by_fast_hierarchy(const SceneFile& scene, std::vector<int> gpus,
                                                 const std::function<void(double)>& progress) {
  ProgressMonitor monitor(progress);
  std::function<void()> meanwhile;
  if (gpus.size() > 1)
    meanwhile = [&] { monitor.check(); }; // by the caller's thread, which else does it itself
  ResidentTracer tracer(
      scene, nullptr, Device::cuda, std::move(gpus),
      [&](int gpu) { return built_files_cuda(scene, gpu, &monitor); }, meanwhile);
  tracer.is_hierarchy_ = true;
  return tracer;
}

StructureFile ResidentTracer::built_hierarchy() const {
  const Structure built = built_hierarchy_cuda(*files_.front());
  return structure_in_memory(
      built, provenance_of(scene_.geometry(), scene_.primitive_count(), fast_hierarchy_options(), built));
}

std::optional<ResidentTracer> ResidentTracer::moved(const Vertices& vertices) const {
  ResidentTracer tracer = *this;
  on_threads(files_.size(), [&](std::size_t i) {
    tracer.files_[i] = moved_files_cuda(*files_[i], scene_.origin(), vertices);
  });
  if (std::ranges::count(tracer.files_, nullptr) > 0) return std::nullopt;
  return tracer;
}

} // namespace masu
