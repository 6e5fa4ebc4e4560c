// Rays traced by a warp together (CUDA sources only). Rays side by side soon have different things to do, and
// a warp takes as long as the lane that has most: so what there is to do is shared out among its lanes.
//
//  - Tests. Lists of cells differ in length, and many rays are in cells that have none. Where at most half of
//    the lanes have a list, each list is tested by several lanes at once; where next to none have, the others
//    go one step further first.
//  - Rays. Lanes whose rays are done fetch new ones, after Aila & Laine, "Understanding the Efficiency of Ray
//    Traversal on GPUs", HPG 2009: soon where rays side by side have little in common, else all at once.
//  - Segments. The last rays are dealt out to all warps (renderer/cuda/straggler_queue.h). The segments that
//    remain of them are split over the lanes.
//
// Results are the same: which hit is nearest, ties included, depends neither on the order of tests nor on the
// lane that makes them, and a walk may begin anywhere along the ray (libgrid/trace/walk.h).
#pragma once

#include "renderer/cuda/straggler_queue.h"
#include "renderer/cuda/warp_rays.h"

namespace masu {

// Tests what the lanes' lists hold, from `list` on; a lane has none for empty_list. `ray` is whose it is;
// own_rays: every lane its own. As lists come to their ends, there are fewer of them from turn to turn: first
// each lane may test its own, later each is shared out.
template <class M, class Stored, class Grid>
__device__ inline void test_lists(const SceneView<Stored>& scene, const Grid& grid, std::uint32_t ray,
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
    const bool nearer = tests && intersect<M::kinds>(scene, rays.tests[part.ray], primitive, t, counts) &&
                        is_nearer(t, primitive, rays.nearest[part.ray].get());
    if (!alone) {
      rays.nearest[part.ray].lower(nearer, {t, primitive});
    } else if (nearer) {
      rays.nearest[lane].set({t, primitive});
    }
  }
}

// So many idle lanes fetch rays: where rays side by side have much in common; where not. If they miss the
// scene, until half as many are left without one. Given at run time: the compiler unrolls loops by a number
// that it knows, and makes them 3 % slower.
inline constexpr int all_fetch = lanes_per_warp, some_fetch = 12;

// Numbers of a list's rays for the lanes of a warp. All warps count at one address, and queue up there where
// most rays miss the scene: so a warp takes some in advance, until the list's last ones.
class RayNumbers {
public:
  __device__ bool may_have_more(std::uint32_t count) const { return next_ < count; }
  __device__ bool are_given_out() const { return next_ == end_; }
  // The next ones for lanes with a bit in `wanting`: from `count` on for nobody. For all lanes at once.
  __device__ std::uint32_t take(std::uint32_t& next_ray, std::uint32_t count, unsigned wanting) {
    constexpr std::uint32_t last_ones = 4 * lanes_per_warp; // of each warp
    const unsigned rank = rank_among(wanting, threadIdx.x % lanes_per_warp), left = end_ - next_;
    const auto wanted = static_cast<unsigned>(__popc(wanting));
    std::uint32_t number = next_ + rank;
    next_ += wanted;
    if (left < wanted) {
      const bool in_advance = end_ + last_ones * gridDim.x * (rays_per_block / lanes_per_warp) < count;
      const unsigned more = in_advance ? lanes_per_warp : wanted - left;
      const std::uint32_t first = add_for_warp(next_ray, static_cast<int>(more));
      if (rank >= left) number = first + rank - left;
      next_ = first + wanted - left;
      end_ = first + more;
    }
    return number;
  }

private:
  std::uint32_t next_ = 0, end_ = 0; // those that were taken and not given out yet
};

// Where fewer lanes found a list, the others first go one step further.
inline constexpr int few_lists = 6;

// The first kernel of two traces rays of the list, and leaves some, which the second one `finishes`.
template <bool finishes, Query query, class M, class Stored, class Grid>
__global__ void __launch_bounds__(rays_per_block, resident_threads_wanted<M> / rays_per_block)
    warp_kernel(const SceneView<Stored> scene, const Grid grid, const Ray<typename M::Real>* const list,
                const std::uint32_t count, const int fetching, const RayResults results,
                const StragglerQueue<typename M::Real> left) {
  using Real = typename M::Real;
  constexpr unsigned warps_a_block = rays_per_block / lanes_per_warp;
  __shared__ WarpRays<typename M::TestRay> block_rays[warps_a_block];
  const unsigned warp = threadIdx.x / lanes_per_warp, lane = threadIdx.x % lanes_per_warp;
  WarpRays<typename M::TestRay>& rays = block_rays[warp];
  // In variables of the kernel's own: what holds references to itself would not stay in registers.
  LaneWalk<Real, Grid> own{{}, RealTraits<Real>::largest, lane, false};
  bool has_ray = false, own_rays = true;
  DrainSignal drain;
  RayNumbers numbers;
  const auto fetch = [&](std::uint32_t number, ClippedRay<Real>& near) {
    has_ray = fetch_ray<query>(scene, list, count, number, results, rays.ends[lane], near);
  };
  const auto begin = [&](const ClippedRay<Real>& near) {
    own.under_way = true;
    rays.nearest[lane].set({near.ray.t_max, 0});
    prepare(rays.tests[lane], near.ray.origin, near.ray.direction);
    own.walk = Walk<Real, Grid>(grid, near);
  };
  const auto report = [&] {
    if (!has_ray) return;
    const RayEnds<Real>& ends = rays.ends[lane];
    write_hit<query>(results, ends.number,
                     reported(rays.nearest[lane].get(), ends.t_max, ends.skipped, ends.scale));
    has_ray = false;
  };
  if constexpr (finishes) {
    const unsigned at = (lane * gridDim.x + blockIdx.x) * warps_a_block + warp;
    if (at < left.progress->left) {
      const Straggler<Real> ray = left.rays[at];
      ClippedRay<Real> near{};
      fetch(ray.number, near);
      begin(near);
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
      const bool is_drained = drain.is_drained();
      if (is_drained && numbers.are_given_out()) {
        const std::uint32_t at = add_for_warp(left.progress->left, __popc(~idle)) + rank_among(~idle, lane);
        if (!own.under_way) return report();
        left.rays[at] = {rays.nearest[lane].get(), own.walk.exit, rays.ends[lane].number};
        return;
      }
      drain.poll(*left.progress);
      if (numbers.may_have_more(count) && __popc(idle) >= (is_drained ? 1 : fetching)) {
        if (!own.under_way) report();
        ClippedRay<Real> near{};
        unsigned wanting = idle;
        do {
          const std::uint32_t number = numbers.take(left.progress->next_ray, count, wanting);
          if (!has_ray) fetch(number, near);
          wanting = __ballot_sync(all_lanes, !has_ray);
        } while (numbers.may_have_more(count) && __popc(wanting) * 2 > fetching);
        if (has_ray && !own.under_way) begin(near);
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
