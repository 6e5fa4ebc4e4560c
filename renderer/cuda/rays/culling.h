// Rays that miss the scene's bounds, whose results are written before the others are traced (CUDA sources
// only).
//
// Where most rays miss, a kernel that traces them mostly waits for rays to fetch. One that only clips them
// needs few registers, so twice as many are under way, and leaves a list of those that are worth it.
#pragma once

#include "renderer/cuda/kernel.h"
#include "renderer/cuda/rays/straggler_queue.h"

namespace masu {

// Rays have numbers of 32 bits, and each warp may once fetch more than there are.
inline constexpr std::uint64_t max_rays_by_warps = 0x7fffffff;

// Rays to be traced: all of them, or those that were chosen.
template <class Real>
struct RayQueue {
  const Ray<Real>* rays;
  std::uint32_t count;
  const std::uint32_t* chosen; // numbers of rays, near their order, where WarpProgress says so; or null
};

// Fewer rays aren't worth a look.
inline constexpr std::uint64_t min_rays_culled = std::uint64_t{1} << 18;
inline constexpr unsigned threads_per_culling_block = 512, rays_sampled = 2 * threads_per_culling_block;

// Whether so many rays miss the bounds that choosing the others pays: measured on an H200, from 9 of 20 on.
// By a sample, the same for every block, all of whose threads call it.
template <class Real, class Stored>
__device__ inline bool often_misses(const SceneView<Stored>& scene, const Ray<Real>* rays,
                                    std::uint32_t count) {
  int missing = 0;
#pragma unroll
  for (unsigned half = 0; half < 2; ++half) {
    const unsigned sample = half * threads_per_culling_block + threadIdx.x;
    ClippedRay<Real> near{};
    Real scale, t_min;
    missing += __syncthreads_count(
        scale_and_clip(scene, rays[sample * (count / rays_sampled)], near, scale, t_min) ? 0 : 1);
  }
  return missing * 20 >= static_cast<int>(rays_sampled) * 9;
}

// Where most rays miss the bounds: chooses those that meet them, and writes the others' results. For as many
// blocks as fit.
template <class Real, class Stored>
__global__ void __launch_bounds__(threads_per_culling_block)
    cull_kernel(const SceneView<Stored> scene, const Ray<Real>* const rays, const std::uint32_t count,
                const Query query, const RayResults results, std::uint32_t* const chosen,
                WarpProgress* const progress) {
  constexpr unsigned warps = threads_per_culling_block / lanes_per_warp;
  __shared__ unsigned before[warps]; // rays chosen by the warps before each
  __shared__ std::uint32_t first;
  if (!often_misses(scene, rays, count)) return;
  if (blockIdx.x == 0 && threadIdx.x == 0) progress->culls = 1;
  const unsigned lane = threadIdx.x % lanes_per_warp, warp = threadIdx.x / lanes_per_warp;
  for (std::uint32_t begin = blockIdx.x * threads_per_culling_block; begin < count;
       begin += gridDim.x * threads_per_culling_block) {
    const std::uint32_t number = begin + threadIdx.x;
    bool meets = false;
    if (number < count) {
      ClippedRay<Real> near{};
      Real scale, t_min;
      meets = scale_and_clip(scene, streamed(rays + number), near, scale, t_min);
      if (!meets && query == Query::occlusion) write_hit<Query::occlusion>(results, number, no_hit());
      if (!meets && query == Query::nearest_hit) write_hit<Query::nearest_hit>(results, number, no_hit());
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
      first = atomicAdd(&progress->chosen, sum);
    }
    __syncthreads();
    if (meets) chosen[first + before[warp] + rank_among(meeting, lane)] = number;
    __syncthreads(); // before the next round writes
  }
}

} // namespace masu
