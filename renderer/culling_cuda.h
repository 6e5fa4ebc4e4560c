// Rays that miss the scene's bounds, answered before the others are traced (CUDA sources only).
//
// Where most rays miss, a kernel that traces them mostly waits for rays to fetch. One that only clips them
// needs few registers, so twice as many are under way, and leaves a list of those that are worth it.
#pragma once

#include "renderer/dispatch.h"
#include "renderer/kernel_cuda.h"

#include <span>

namespace masu {

// Rays have numbers of 32 bits, and each warp may once ask for more than there are.
inline constexpr std::uint64_t most_rays_by_warps = 0x7fffffff;

// Rays to be traced: all of them, or those that were chosen.
template <class Real>
struct RayList {
  const TypedRay<Real>* rays;
  std::uint32_t count;
  const std::uint32_t* chosen; // numbers of rays, near their order; null: all are
  const std::uint32_t* chosen_count;

  __device__ std::uint32_t size() const { return chosen != nullptr ? *chosen_count : count; }
  __device__ std::uint32_t number(std::uint32_t i) const { return chosen != nullptr ? chosen[i] : i; }
};

inline constexpr int rays_a_culling_block = 512;

// Chooses the rays that meet the bounds, and answers the others. `chosen_count` is 0 at first.
template <Query query, class Real, class Stored>
__global__ void __launch_bounds__(rays_a_culling_block)
    cull_kernel(const SceneView<Stored> scene, const TypedRay<Real>* const rays, const std::uint32_t count,
                const HitName name, HitRecord* const hits, std::uint32_t* const chosen,
                std::uint32_t* const chosen_count) {
  constexpr int warps = rays_a_culling_block / lanes_a_warp;
  __shared__ unsigned before[warps]; // rays chosen by the warps before each
  __shared__ std::uint32_t first;
  const unsigned lane = threadIdx.x % lanes_a_warp, warp = threadIdx.x / lanes_a_warp;
  const std::uint32_t number = blockIdx.x * rays_a_culling_block + threadIdx.x;
  bool meets = false;
  if (number < count) {
    const ListedNear<Real> ray = clipped<query>(scene, streamed(rays + number));
    meets = ray.meets;
    if (!meets) {
      const Real t_max = ray.near.ray.t_max;
      hits[number] = answer<query>(scene, Hit<Real>{t_max, 0}, t_max, ray.near.skipped, ray.scale, name);
    }
  }
  const unsigned meeting = __ballot_sync(all_lanes, meets);
  if (lane == 0) before[warp] = static_cast<unsigned>(__popc(meeting));
  __syncthreads();
  if (threadIdx.x == 0) {
    unsigned sum = 0;
    for (unsigned& warps_rays : before) {
      const unsigned own = warps_rays;
      warps_rays = sum;
      sum += own;
    }
    first = DeviceAtomic<std::uint32_t>(*chosen_count).fetch_add(sum, cuda::memory_order_relaxed);
  }
  __syncthreads();
  if (meets) chosen[first + before[warp] + rank_among(meeting, lane)] = number;
}

// Whether so many rays miss the bounds that choosing the others pays: measured on an H200, from 9 of 20 on.
// As a sample of them tells.
template <Query query, class Real, class Stored>
bool often_misses(const SceneView<Stored>& scene, std::span<const ListedRay> rays) {
  constexpr std::size_t looked_at = 4096;
  const std::size_t step = rays.size() / looked_at + 1;
  std::size_t missing = 0, sampled = 0;
  for (std::size_t i = 0; i < rays.size(); i += step, ++sampled)
    missing += clipped<query>(scene, typed<Real>(rays[i])).meets ? 0 : 1;
  return missing * 20 >= sampled * 9;
}

} // namespace masu
