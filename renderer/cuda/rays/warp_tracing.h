// Rays traced by a warp together (CUDA sources only). Rays side by side soon have different things to do, and
// a warp takes as long as the lane that has most: so what there is to do is shared out among its lanes.
//
//  - Tests. Lists of cells differ in length, and many rays are in cells that have none. Where at most half of
//    the lanes have a list, each list is tested by several lanes at once; where next to none have, the others
//    go one step further first.
//  - Rays. Lanes whose rays are done fetch new ones, after Aila & Laine, "Understanding the Efficiency of Ray
//    Traversal on GPUs", HPG 2009: soon where rays side by side have little in common, else all at once.
//  - Segments. The last rays are dealt out to all warps (renderer/cuda/rays/straggler_queue.h). The
//    segments that remain of them are split over the lanes.
//
// Results are the same: which hit is nearest, ties included, depends neither on the order of tests nor on the
// lane that makes them, and a walk may begin anywhere along the ray (libgrid/grid/grid_walk.h).
#pragma once

#include "renderer/cuda/rays/culling.h"
#include "renderer/cuda/rays/straggler_queue.h"
#include "renderer/cuda/rays/warp_rays.h"

namespace masu {

// Tests what the lanes' lists hold, from `list` on; a lane has none for empty_list. `ray` is whose it is;
// own_rays: every lane its own. As lists come to their ends, there are fewer of them from turn to turn: first
// each lane may test its own, later each is shared out.
template <class M, class Stored, class Structure>
__device__ inline void test_lists(const SceneView<Stored>& scene, const Structure& grid, std::uint32_t ray,
                                  std::uint32_t list, bool own_rays, WarpRays<typename M::TestRay>& rays) {
  using Real = typename M::Real;
  const unsigned lane = threadIdx.x % lanes_per_warp, lanes_below = (1U << lane) - 1;
  NoCounts counts;
  PrimitiveIndex ahead = list != empty_list ? grid.references[list] : last_bit; // references[list]
  for (;;) {
    const unsigned having = __ballot_sync(all_lanes, list != empty_list);
    if (having == 0) return;
    const int lists = __popc(having);
    const bool alone = own_rays && lists > lanes_per_warp / 2; // every lane tests its own list
    SharedOut part{ray, list};
    PrimitiveIndex reference = ahead;
    bool tests = list != empty_list;
    if (alone) {
      list = (ahead & last_bit) != 0 ? empty_list : list + 1;
      if (list != empty_list) ahead = grid.references[list];
    } else {
      const int log2 = lanes_log2_for_each(lists);
      const int rank = __popc(having & lanes_below);
      __syncwarp(); // what was shared out before has been read
      if (list != empty_list) rays.shared_out[rank] = part;
      __syncwarp();
      const int group = static_cast<int>(lane) >> log2;
      const unsigned in_group = lane & ((1U << log2) - 1);
      part = rays.shared_out[group];
      tests = group < lists;
      reference = tests ? grid.references[part.list + in_group] : last_bit;
      const unsigned lasts = __ballot_sync(all_lanes, (reference & last_bit) != 0);
      // What comes after a list's last one is another's.
      tests = tests && (lasts & lanes_below & (all_lanes << (lane - in_group))) == 0;
      if (list != empty_list) {
        const unsigned group_lanes = all_lanes >> (lanes_per_warp - (1 << log2));
        list = (lasts >> (rank << log2) & group_lanes) != 0 ? empty_list : list + (1U << log2);
      }
    }
    const PrimitiveIndex primitive = reference & ~last_bit;
    Real t = 0;
    const bool nearer = tests &&
                        test_primitive<M::kinds>(scene, rays.tests[part.ray], primitive,
                                                 rays.ends[part.ray].t_min, t, counts) &&
                        is_nearer(t, primitive, rays.nearest[part.ray].get());
    if (!alone) {
      rays.nearest[part.ray].lower(nearer, {t, primitive});
    } else if (nearer) {
      rays.nearest[lane].set({t, primitive});
    }
  }
}

// So many idle lanes fetch rays: where rays side by side have much in common; where not; where rays were
// chosen, so that fetching one takes two loads, one after the other. Given at run time: the compiler unrolls
// loops by a number that it knows, and makes them 3 % slower.
inline constexpr int all_fetch = lanes_per_warp, some_fetch = 12, some_fetch_chosen = 16;

// Where fewer lanes found a list, the others first go one step further.
inline constexpr int few_lists = 6;

// The first kernel of two traces rays of the list, and leaves some, which the second one `finishes`.
template <bool finishes, Query query, class M, class Stored, class Structure>
__global__ void __launch_bounds__(rays_per_block, resident_threads_wanted<M> / rays_per_block)
    warp_kernel(const SceneView<Stored> scene, const Structure grid, const RayQueue<typename M::Real> queue,
                const int fetching, const RayResults results, const StragglerQueue<typename M::Real> left) {
  using Real = typename M::Real;
  constexpr unsigned warps_per_block = rays_per_block / lanes_per_warp;
  __shared__ WarpRays<typename M::TestRay> block_rays[warps_per_block];
  // Looked up where rays are fetched, for they would take up registers.
  __shared__ struct {
    const std::uint32_t* chosen; // null: all rays
    std::uint32_t count;
    int fetches_at;
  } shared;
  if constexpr (!finishes) {
    if (threadIdx.x == 0) {
      const bool culls = queue.chosen != nullptr && left.progress->culls != 0;
      shared = {culls ? queue.chosen : nullptr, culls ? left.progress->chosen : queue.count,
                culls ? some_fetch_chosen : fetching};
    }
    __syncthreads();
  }
  const unsigned warp = threadIdx.x / lanes_per_warp, lane = threadIdx.x % lanes_per_warp;
  WarpRays<typename M::TestRay>& rays = block_rays[warp];
  // In variables of the kernel's own: what holds references to itself would not stay in registers.
  LaneWalk<Real, Structure> own{{}, RealTraits<Real>::largest, lane, false};
  bool has_ray = false, more = true, own_rays = true;
  DrainSignal drain;
  const auto begin = [&](std::uint32_t number) {
    ClippedRay<Real> near{};
    RayEnds<Real>& ends = rays.ends[lane];
    Real scale;
    const bool meets = scale_and_clip(scene, streamed(queue.rays + number), near, scale, ends.t_min);
    has_ray = true;
    own.under_way = meets;
    ends.scale = scale;
    ends.skipped = near.skipped;
    ends.t_max = near.ray.t_max;
    ends.number = number;
    rays.nearest[lane].set({near.ray.t_max, 0});
    if (!meets) return;
    prepare(rays.tests[lane], near.ray.origin, near.ray.direction);
    own.walk = Walk<Real, Structure>(grid, near);
  };
  const auto report = [&] {
    if (!has_ray) return;
    const RayEnds<Real>& ends = rays.ends[lane];
    write_hit<query>(results, ends.number,
                     reported(rays.nearest[lane].get(), ends.t_max, ends.skipped, ends.scale));
    has_ray = false;
  };
  if constexpr (finishes) {
    const unsigned at = (lane * gridDim.x + blockIdx.x) * warps_per_block + warp;
    if (at < left.progress->left) {
      const Straggler<Real> ray = left.rays[at];
      begin(ray.number);
      rays.nearest[lane].set(ray.nearest);
      own.walk.begin_at(grid, ray.from);
    }
  }
  for (;;) {
    const unsigned idle = __ballot_sync(all_lanes, !own.under_way);
    if constexpr (finishes) {
      if (idle == all_lanes) return report();
      if (__popc(idle) >= lanes_per_warp / 2) {
        split_segments(grid, ~idle, rays, own);
        own_rays = false;
      }
    } else {
      if (drain.is_drained()) {
        const std::uint32_t at = add_for_warp(left.progress->left, __popc(~idle)) + rank_among(~idle, lane);
        if (!own.under_way) return report();
        left.rays[at] = {rays.nearest[lane].get(), own.walk.exit, rays.ends[lane].number};
        return;
      }
      drain.poll(*left.progress);
      if (more && __popc(idle) >= shared.fetches_at) {
        const std::uint32_t first = add_for_warp(left.progress->next_ray, __popc(idle)),
                            number = first + rank_among(idle, lane);
        const std::uint32_t count = shared.count;
        more = first + static_cast<unsigned>(__popc(idle)) < count;
        if (!own.under_way) {
          report();
          if (number < count) begin(shared.chosen != nullptr ? shared.chosen[number] : number);
        }
        continue;
      }
      if (idle == all_lanes) {
        DrainSignal::give(*left.progress);
        return report();
      }
    }
    const auto go_on = [&] {
      const bool done =
          can_terminate<query>(rays.nearest[own.ray].get().t, rays.ends[own.ray].t_max, own.walk.exit);
      own.under_way = own.walk.leave(grid) & !done & (own.walk.exit < own.end);
    };
    if (own.under_way) own.walk.enter(grid);
    // So few lists are better tested with those that others find one step further.
    const bool has_list = own.under_way && own.walk.cell.list != empty_list;
    if (__popc(__ballot_sync(all_lanes, has_list)) < few_lists && own.under_way && !has_list) {
      go_on();
      if (own.under_way) own.walk.enter(grid);
    }
    __syncwarp();
    test_lists<M>(scene, grid, own.ray, own.under_way ? own.walk.cell.list : empty_list, own_rays, rays);
    if (own.under_way) go_on();
  }
}

} // namespace masu
