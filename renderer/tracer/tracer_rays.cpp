// A tracer's queries of lists of rays: who doesn't call them doesn't link them.
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

[[noreturn]] void fail(const char* place, const std::string& what) {
  throw Error(ErrorCode::usage, place, what);
}

// Rounded to the arithmetic's numbers, in memory of the device.
template <class Real>
ResidentRays resident_rays(std::span<const Ray<double>> rays, const std::vector<int>& gpus) {
  std::vector<Ray<Real>> rounded(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    rounded[i] = loaded<Real>(rays.data(), own_format<double>, i);
  if (!gpus.empty()) return upload_rays_cuda(relative(RayList(rounded)), gpus.front());
  struct Memory {
    std::vector<Ray<Real>> rays;
    std::vector<float> t;
    std::vector<std::uint32_t> primitive;
    std::vector<std::uint8_t> occluded;
  };
  const auto memory = std::make_shared<Memory>();
  memory->rays = std::move(rounded);
  memory->t.resize(rays.size());
  memory->primitive.resize(rays.size());
  memory->occluded.resize(rays.size());
  ResidentRays resident{relative(RayList(memory->rays)), {}, memory};
  resident.results.t = memory->t.data();
  resident.results.primitive = memory->primitive.data();
  resident.results.occluded = memory->occluded.data();
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
  if (rays.placed_filters.any()) fail("rays", "have worlds or excluded objects: the scene has no placements");
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
  std::atomic<std::size_t> next_piece = 0;
  return trace_rays_cuda(*files_.at(index), relative_to(scene_.origin(), rays), results, resolved_request,
                         next_piece);
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

} // namespace masu
