// Rays traced by a warp together (CUDA sources only). Rays side by side soon have different things to do, and
// a warp takes as long as the lane that has most: so what there is to do is shared out among its lanes.
//
//  - Tests. Lists of cells differ in length, and many rays are in cells that have none. Where at most half of
//    the lanes have a list, each list is tested by several lanes at once; where next to none have, the others
//    go one step further first.
//  - Rays. Lanes whose rays are done fetch new ones, after Aila & Laine, "Understanding the Efficiency of Ray
//    Traversal on GPUs", HPG 2009.
//  - Ways. Once no ray is left to fetch, the ways that the last rays have still to go are cut into pieces, of
//    which each is walked by a lane of its own: of the same warp, or while most lanes are busy, of others
//    that have run out (renderer/way_pool_cuda.h).
//
// None of it shows: which hit is nearest, ties included, depends neither on the order of tests nor on who
// makes them, and a walk may begin anywhere on the ray's way (libgrid/walk.h).
#pragma once

#include "renderer/culling_cuda.h"
#include "renderer/warp_rays_cuda.h"

namespace masu {

// Tests what the lanes' lists hold, from `list` on; a lane has none for empty_list. `ray` is whose it is;
// own_rays: every lane its own. As lists come to their ends, there are fewer of them from turn to turn: first
// each lane may test its own, later each is shared out.
template <class M, class Stored, class Grid>
__device__ inline void test_lists(const SceneView<Stored>& scene, const Grid& grid, std::uint32_t ray,
                                  std::uint32_t list, bool own_rays, WarpRays<typename M::TestRay>& rays) {
  using Real = typename M::Real;
  const unsigned lane = threadIdx.x % lanes_a_warp, lanes_below = (1U << lane) - 1;
  NoCounts counts;
  PrimitiveIndex ahead = list != empty_list ? grid.references[list] : last_bit; // references[list]
  for (;;) {
    const unsigned having = __ballot_sync(all_lanes, list != empty_list);
    if (having == 0) return;
    const int lists = __popc(having);
    const bool alone = own_rays && lists > lanes_a_warp / 2; // every lane tests its own list
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
        const unsigned group_lanes = all_lanes >> (lanes_a_warp - (1 << log2));
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

// A ray for a lane to begin, or a piece of a shared one's way.
struct Begun {
  bool any;
  std::uint64_t number; // of the ray in the list
  PooledWay way;        // the whole way, where its ray is not_shared
};

// A block's warps trace rays: its own, or if it `refills`, as many as there are; then it needs the pool. M:
// with StopRule::proven.
template <bool refills, Question question, class M, class Stored, class Grid>
__global__ void __launch_bounds__(rays_a_block, resident_threads_wanted<M> / rays_a_block)
    warp_kernel(const SceneView<Stored> scene, const Grid grid, const RayList<typename M::Real> list,
                const HitName name, EyeHit* const hits, const WayPool pool) {
  static_assert(M::stop == StopRule::proven);
  using Real = typename M::Real;
  // So many lanes fetch at once, so that it pays to stop for it; and so often ways are divided, in turns.
  constexpr int enough = refills ? 12 : lanes_a_warp, divided_every = 2, few_lists = 6;
  constexpr bool shares = refills && sizeof(Real) == sizeof(float); // as SharedRay needs it
  __shared__ WarpRays<typename M::TestRay> block_rays[rays_a_block / lanes_a_warp];
  WarpRays<typename M::TestRay>& rays = block_rays[threadIdx.x / lanes_a_warp];
  const unsigned lane = threadIdx.x % lanes_a_warp;
  // In variables of the kernel's own: what holds references to itself would not stay in registers.
  LaneWalk<Real, Grid> own{{}, 0, lane, false};
  bool more = true, has_ray = false, own_rays = true;
  int turn = 0;
  PoolWatch watch;
  const std::uint64_t count = list.size();
  if constexpr (shares) start(pool);
  const auto tell = [&] {
    const RayEnds<Real>& ends = rays.ends[lane];
    hits[ends.number] =
        answer<question>(scene, rays.nearest[lane].get(), ends.t_max, ends.skipped, ends.scale, name);
  };
  for (;;) {
    const unsigned idle = __ballot_sync(all_lanes, !own.under_way);
    const bool fetches = more && __popc(idle) >= enough;
    if (fetches || idle == all_lanes) {
      Begun next{false, 0, {not_shared, 0, 0}};
      if (fetches) {
        next.number = std::uint64_t{blockIdx.x} * rays_a_block + threadIdx.x;
        more = false;
        if constexpr (refills) {
          std::uint64_t first = 0;
          if (lane == 0)
            first = DeviceAtomic<std::uint64_t>(pool.state->next_ray)
                        .fetch_add(static_cast<unsigned>(__popc(idle)), cuda::memory_order_relaxed);
          first = __shfl_sync(all_lanes, first, 0);
          more = first + static_cast<unsigned>(__popc(idle)) < count;
          next.number = first + static_cast<unsigned>(__popc(idle & ((1U << lane) - 1)));
        }
        next.any = next.number < count;
        if (next.any) next.number = list.number(next.number);
        if (!own.under_way && has_ray) tell();
      } else {
        bool told = has_ray;
        if constexpr (shares) {
          if (has_ray && rays.ends[lane].shared != not_shared) {
            Hit<Real> nearest = rays.nearest[lane].get();
            told = settle(pool.rays[rays.ends[lane].shared], nearest);
            rays.nearest[lane].set(nearest);
          }
        }
        if (told) tell();
        if constexpr (!shares) return;
        WayBundle* const bundle = next_bundle(pool, threadIdx.x < lanes_a_warp);
        if (bundle == nullptr) return;
        next.any = take_way(*bundle, next.way);
        if (next.any) next.number = pool.rays[next.way.ray].number;
        own_rays = true;
        own.ray = lane;
      }
      if (!own.under_way) {
        has_ray = next.any;
        if (has_ray) {
          const auto [near, scale, meets] = clipped<question>(scene, streamed(list.rays + next.number));
          own.under_way = meets;
          rays.ends[lane] = {scale, near.skipped, near.ray.t_max, next.way.ray,
                             static_cast<std::uint32_t>(next.number)};
          rays.nearest[lane].set({near.ray.t_max, 0});
          if (own.under_way) {
            prepare(rays.tests[lane], near.ray.origin, near.ray.direction);
            own.walk = Walk<Real, Grid>(grid, near);
            own.end = RealTraits<Real>::largest;
          }
          if constexpr (shares) {
            if (next.way.ray != not_shared) {
              rays.nearest[lane].set(nearest_of(pool.rays[next.way.ray]));
              own.walk.begin_at(grid, next.way.from);
              own.end = next.way.to;
            }
          }
        }
      }
      continue;
    }
    if (refills && !more && ++turn >= divided_every) {
      turn = 0;
      if (__popc(idle) >= lanes_a_warp / 2) {
        cut_ways(grid, ~idle, rays, own);
        own_rays = false;
      } else if constexpr (shares) {
        if (watch.enough_waited(pool)) give_ways(grid, pool, has_ray, rays, own);
        watch.ask(pool);
      }
    }
    const auto go_on = [&] {
      const bool answered =
          is_answered<question>(rays.nearest[own.ray].get(), rays.ends[own.ray].t_max, own.walk.exit);
      own.under_way = own.walk.leave(grid) & !answered & (own.walk.exit < own.end);
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
