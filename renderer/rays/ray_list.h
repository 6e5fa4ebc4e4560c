// A list of rays, what is asked of it, and where the results go.
#pragma once

#include "renderer/rays/hit_list.h"
#include "renderer/rays/ray_query.h"
#include "renderer/render_pixel.h"
#include "renderer/tracing_rules.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace masu {

// Rays in memory, stored as ray_query.h says; or places (closest_points.h).
struct RayList {
  const void* rays = nullptr;
  std::size_t count = 0;
  RayFormat format{};
  RayFilters filters{};

  RayList() = default;
  RayList(const void* rays_, std::size_t count_, const RayFormat& format_)
      : rays(rays_), count(count_), format(format_) {}
  template <class Real>
  RayList(std::span<const Ray<Real>> list) : RayList(list.data(), list.size(), own_format<Real>) {}
  template <class Real>
  RayList(const std::vector<Ray<Real>>& list) : RayList(std::span(list)) {}
};

// The same rays, whose origins are relative to the scene's.
inline RayList relative(RayList rays) {
  rays.format.is_relative = true;
  return rays;
}

// With what is to be subtracted from their origins, where that is the scene's.
inline RayList relative_to(const Vec3d& origin, RayList rays) {
  rays.format.origin = rays.format.is_relative ? Vec3d{0, 0, 0} : origin;
  return rays;
}

// Throws Error(usage) where a scene of these bounds is too large for distances (max_closest).
void check_closest(const Boxd& bounds);

struct RaysRequest;
// Throws Error(usage) for filters that aren't for a scene of so many objects, for results that a query needs
// and doesn't have, and for hits in order that aren't to be had. The request's precision is resolved.
void check_query(const RayList& rays, const RayResults& results, const RaysRequest& request,
                 std::uint64_t objects);

// How a GPU schedules rays. thread_per_ray: a thread traces one ray to its end, and a warp's threads wait for
// each other at every cell. warp: its threads share the primitive tests of its rays. warp_refill: besides,
// idle threads fetch the next ray (renderer/cuda/rays/warp_tracing.h), and where most rays miss the scene's
// bounds those are sorted out first (renderer/cuda/rays/culling.h). automatic: through a hierarchy the first
// or the last of these, chosen on the GPU (renderer/cuda/rays/loop_choice.h); else warp_refill. Hits are the
// same.
enum class RayLoop : std::int32_t { thread_per_ray, warp, warp_refill, automatic };

inline constexpr std::uint32_t max_hits_per_ray = 0x7fffffff;

struct RaysRequest {
  TracingRules tracing{};
  Query query = Query::nearest_hit;
  // Always thread_per_ray where rays are counted, stop with the first cell's hit, or are 2^31 or more; and
  // for occlusion by `fast` and `double`.
  RayLoop loop = RayLoop::warp_refill;
  Faces faces = Faces::both; // that count as hits
  std::uint32_t limit = 1;   // hits per ray, of all_hits
  // Of a list in host memory: gets the share of rays traced, now and then, from any thread; what it throws
  // ends the query.
  std::function<void(double)> progress{};
};

// Whether hits are found in their order (hit_list.h), by `robust` or `double`, and aren't counted.
inline bool needs_hits_in_order(const RayList& rays, const RayResults& results, const RaysRequest& request) {
  if (request.query == Query::closest_point) return false;
  return request.query == Query::all_hits || request.query == Query::count_hits ||
         request.faces != Faces::both || rays.filters.any() || results.t64 != nullptr ||
         results.front != nullptr;
}
inline HitRules hit_rules(const RaysRequest& request) {
  return {request.query, request.faces, request.limit};
}

// What a query took. Seconds of a list in host memory overlap on a GPU.
struct QueryReport {
  Counts counts;
  TraceSeconds seconds;
  KernelSize kernel{};
};

// The results of a list of rays as records.
struct RayHits {
  std::vector<HitRecord> hits; // one per ray, in the list's order; for occlusion t is 1, name 0 or -1
  QueryReport report;
};

// Rays with room for their results where a tracer traces them, to be traced many times; relative to the
// scene's origin.
struct ResidentRays {
  RayList list;
  RayResults results;
  std::shared_ptr<void> memory{}; // what they point to
};

} // namespace masu
