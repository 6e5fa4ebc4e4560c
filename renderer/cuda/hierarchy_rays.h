// Rays through a bounding volume hierarchy by warps whose idle lanes fetch the next ray (CUDA sources only):
// after Aila & Laine, "Understanding the Efficiency of Ray Traversal on GPUs", HPG 2009, and, for when to
// fetch, Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
// HPG 2017.
#pragma once

#include "libgrid/trace/hierarchy_walk.h"
#include "renderer/cuda/straggler_queue.h"
#include "renderer/cuda/warp_rays.h"

namespace masu {

inline constexpr int hierarchy_threads = 64; // a block: small ones end soon after their last ray

// Lanes fetch rays once so many lane steps were idle: lanes beyond idle_lanes_tolerated, summed over steps.
inline constexpr int max_idle_steps = 8, idle_lanes_tolerated = 4;

template <Query query, class M, class Stored, class Hierarchy>
__global__ void __launch_bounds__(hierarchy_threads, resident_threads_wanted<M> / hierarchy_threads)
    refill_kernel(const SceneView<Stored> scene, const Hierarchy hierarchy,
                  const Ray<typename M::Real>* const rays, const std::uint32_t count,
                  const RayResults results, std::uint32_t* const next_ray) {
  using Real = typename M::Real;
  // What is needed of a ray when it is begun and ended would take up registers.
  __shared__ RayEnds<Real> ends[hierarchy_threads];
  const unsigned lane = threadIdx.x % lanes_per_warp;
  RayEnds<Real>& own = ends[threadIdx.x];
  NoCounts counts;
  HierarchyStack stack;
  HierarchyWalk<Real> walk;
  typename M::TestRay test_ray;
  Hit<Real> nearest{};
  bool has_ray = false, under_way = false, more = true;
  for (;;) {
    unsigned idle = __ballot_sync(all_lanes, !under_way);
    // By the lanes that fetch the next ones, more than end at the same time.
    if (has_ray && !under_way) {
      write_hit<query>(results, own.number, reported(nearest, own.t_max, own.skipped, own.scale));
      has_ray = false;
    }
    if (more && idle != 0) {
      const std::uint32_t first = add_for_warp(*next_ray, __popc(idle)),
                          number = first + rank_among(idle, lane);
      more = first + static_cast<unsigned>(__popc(idle)) < count;
      if (!under_way && number < count) {
        ClippedRay<Real> near{};
        Real scale;
        if (scale_and_clip(scene, streamed(rays + number), near, scale)) {
          has_ray = under_way = true;
          own = {scale, near.skipped, near.ray.t_max, number};
          nearest = {near.ray.t_max, 0};
          prepare(test_ray, near.ray.origin, near.ray.direction);
          walk.begin(near);
        } else {
          write_hit<query>(results, number, {static_cast<float>(INFINITY), no_primitive});
        }
      }
      idle = __ballot_sync(all_lanes, !under_way);
      if (more && __popc(idle) > lanes_per_warp / 2) continue; // most miss the scene
    }
    if (idle == all_lanes) return;
    int idle_steps = 0;
    while (under_way) {
      if constexpr (query == Query::nearest_hit) {
        // 0: t_max is for the rule of termination, which only grids use.
        NearestHit<M, Stored, NoCounts> visitor{scene, test_ray, counts, 0, nearest};
        under_way = walk.advance(hierarchy, stack, visitor);
        nearest = visitor.hit;
      } else {
        AnyHit<M, Stored, NoCounts> visitor{scene, test_ray, counts, own.t_max, nearest.t};
        under_way = walk.advance(hierarchy, stack, visitor);
        nearest.t = visitor.hit;
      }
      if (more) {
        idle_steps += max(lanes_per_warp - idle_lanes_tolerated - __popc(__activemask()), 0);
        if (idle_steps >= max_idle_steps) break;
      }
    }
    __syncwarp();
  }
}

} // namespace masu
