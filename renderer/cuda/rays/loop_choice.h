// The loop by which rays in a GPU's memory go through a hierarchy, chosen there, so that nothing waits for
// the host (CUDA sources only): both loops' kernels are launched, and one of them ends at once.
#pragma once

#include "libscene/cuda/warp.h"
#include "renderer/cuda/kernel.h"
#include "renderer/rays/ray_list.h"
#include "renderer/rays/ray_query.h"

namespace masu {

// Looking takes some 8 us, which is worth it for as many rays. Of fewer, closest hits are found by
// warp_refill, where there are some to fetch.
inline constexpr std::uint64_t min_rays_looked_at = std::uint64_t{1} << 19,
                               min_rays_fetched = std::uint64_t{1} << 17;

// Whether a loop is that of the list: one that the host chose (null) is.
__device__ inline bool is_chosen(RayLoop loop, const RayLoop* chosen) {
  return chosen == nullptr || __ldg(reinterpret_cast<const int*>(chosen)) == static_cast<int>(loop);
}

// Whether a ray runs so much the way of its warp's first one that few wait for others: within 30 degrees; for
// any hit, which comes soon, within 90. For all lanes at once, of which one has a ray at least.
template <Query query, class Real>
__device__ inline bool is_coherent(const Vec3<Real>& direction, bool has_ray) {
  const Vec3<Real> first = from_lane(direction, __ffs(__ballot_sync(all_lanes, has_ray)) - 1);
  const Real along = dot(direction, first);
  if constexpr (query == Query::occlusion) return has_ray && along > 0;
  const bool is_near =
      along > 0 && along * along > Real{0.75} * (dot(direction, direction) * dot(first, first));
  const bool are_all = __all_sync(all_lanes, is_near || !has_ray);
  return has_ray && are_all;
}

inline constexpr int warps_looked_at = 32; // one block's

// Chooses thread_per_ray for rays whose neighbours are coherent, and where few come near the scene, which
// takes no fetching; else warp_refill. Looks at warps all over the list: at places i · φ modulo 1, which are
// as far from each other as can be. Sets `parts` numbers of fetched rays to 0.
template <Query query, class Real, class Stored>
__global__ void choose_loop_kernel(const SceneView<Stored> scene, const Ray<Real>* const rays,
                                   const std::uint64_t count, RayLoop* const chosen,
                                   std::uint32_t* const fetched, const std::uint32_t parts) {
  const unsigned warp = threadIdx.x / lanes_per_warp, lane = threadIdx.x % lanes_per_warp;
  constexpr std::uint32_t phi = 2654435769U; // 2^32 (√5 - 1) / 2
  const std::uint64_t place = (warp * phi * (count / lanes_per_warp)) >> 32;
  for (std::uint32_t part = threadIdx.x; part < parts; part += blockDim.x)
    fetched[part] = 0;
  Real scale, t_min;
  ClippedRay<Real> near{};
  const bool meets =
      scale_and_clip(scene, streamed(rays + place * lanes_per_warp + lane), near, scale, t_min);
  const bool alike = __any_sync(all_lanes, meets) && is_coherent<query>(near.ray.direction, meets);
  const int meeting = __syncthreads_count(meets), coherent = __syncthreads_count(alike);
  if (threadIdx.x != 0) return;
  // Of rays about a surface's normal, as those of ambient occlusion, some four fifths run within 90 degrees:
  // they end as differently as diffuse ones.
  constexpr int most_eighths = query == Query::occlusion ? 7 : 6;
  const bool mostly_coherent = 8 * coherent > most_eighths * meeting,
             mostly_away = 4 * meeting < warps_looked_at * lanes_per_warp;
  *chosen = mostly_coherent || mostly_away ? RayLoop::thread_per_ray : RayLoop::warp_refill;
}

} // namespace masu
