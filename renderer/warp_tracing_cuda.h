// Rays traced by a warp together (CUDA sources only). Rays side by side soon have different things to do, and
// a warp takes as long as the lane that has most: so what there is to do is shared out among its lanes.
//
//  - Tests. Lists of cells differ in length, and many rays are in cells that have none. Where at most half of
//    the lanes have a list, each list is tested by several lanes at once.
//  - Rays. Lanes whose rays are done fetch new ones, after Aila & Laine, "Understanding the Efficiency of Ray
//    Traversal on GPUs", HPG 2009.
//  - Ways. Once no ray is left to fetch, the ways that the last rays have still to go are cut into pieces, of
//    which each is walked by a lane of its own.
//
// None of it shows: which hit is nearest, ties included, depends neither on the order of tests nor on who
// makes them, and a walk may begin anywhere on the ray's way (libgrid/walk.h).
#pragma once

#include "renderer/dispatch.h"
#include "renderer/kernel_cuda.h"

namespace masu {

inline constexpr int rays_a_block = 128;

// Of so many lanes that have something to be shared out, each gets 2^n lanes for it.
__device__ inline int lanes_log2_for_each(int having) {
  return having > lanes_a_warp / 2 ? 0 : __clz(having - 1) - 27;
}

// What is needed of a ray when it is begun and ended.
template <class Real>
struct RayEnds {
  Real scale, skipped, t_max;
  std::uint64_t number;
};

// What a lane has for others to help with: a list of its ray's, or a way.
struct SharedOut {
  std::uint32_t ray, list;
};

// The rays of a warp, in shared memory: any lane may work on any of them. A lane's own ray has the lane's
// number.
template <class TestRay>
struct WarpRays {
  using Real = typename TestRay::Real;
  TestRay tests[lanes_a_warp];
  Hit<Real> nearest[lanes_a_warp]; // so far; as NearestHit (libgrid/trace.h) has it
  RayEnds<Real> ends[lanes_a_warp];
  SharedOut shared_out[lanes_a_warp]; // one after another
};

// A lane's walk: along the whole way of its own ray, or a piece of any ray's.
template <class Real, class Grid>
struct LaneWalk {
  Walk<Real, Grid> walk;
  Real end;          // of the piece
  std::uint32_t ray; // whose way it is
  bool under_way;
};

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
                        is_nearer(t, primitive, rays.nearest[part.ray]);
    if (alone) {
      if (nearer) rays.nearest[lane] = {t, primitive};
      continue;
    }
    // One lane after another: they may have hit with the same ray.
    for (unsigned left = __ballot_sync(all_lanes, nearer); left != 0; left &= left - 1) {
      if (static_cast<int>(lane) == __ffs(left) - 1 && is_nearer(t, primitive, rays.nearest[part.ray]))
        rays.nearest[part.ray] = {t, primitive};
      __syncwarp();
    }
  }
}

template <class T>
__device__ inline T from_lane(const T& value, int lane) {
  struct Words {
    std::uint32_t words[sizeof(T) / 4];
  };
  static_assert(sizeof(Words) == sizeof(T));
  Words moved = __builtin_bit_cast(Words, value);
#pragma unroll
  for (std::uint32_t& word : moved.words)
    word = __shfl_sync(all_lanes, word, lane);
  return __builtin_bit_cast(T, moved);
}

// Cuts what the walks under way have still to go, of which there are at most half as many as lanes, into as
// many pieces of equal length as there are lanes for each; but into none shorter than a voxel.
template <class TestRay, class Grid>
__device__ inline void cut_ways(const Grid& grid, unsigned under_way, WarpRays<TestRay>& rays,
                                LaneWalk<typename TestRay::Real, Grid>& own) {
  using Real = typename TestRay::Real;
  const unsigned lane = threadIdx.x % lanes_a_warp;
  const int ways = __popc(under_way), log2 = lanes_log2_for_each(ways);
  __syncwarp(); // what was shared out before has been read
  if (own.under_way) rays.shared_out[__popc(under_way & ((1U << lane) - 1))].ray = lane;
  __syncwarp();
  const int way = static_cast<int>(lane) >> log2, piece = static_cast<int>(lane) & ((1 << log2) - 1);
  const int source = static_cast<int>(rays.shared_out[way < ways ? way : 0].ray);
  Walk<Real, Grid>& walk = own.walk;
  own.ray = __shfl_sync(all_lanes, own.ray, source);
  own.end = from_lane(own.end, source);
  walk.x = from_lane(walk.x, source);
  walk.y = from_lane(walk.y, source);
  walk.z = from_lane(walk.z, source);
  walk.exit = from_lane(walk.exit, source);
  own.under_way = way < ways;
  const Real from = walk.exit, to = least(own.end, least(walk.end(grid), rays.nearest[own.ray].t));
  const Real step = (to - from) / static_cast<Real>(1 << log2);
  if (!(step * walk.speed() > 1)) {
    own.under_way = own.under_way && piece == 0;
    return;
  }
  if (piece + 1 < 1 << log2) own.end = fused(step, static_cast<Real>(piece + 1), from);
  if (piece > 0) walk.begin_at(grid, fused(step, static_cast<Real>(piece), from));
}

// A block's warps trace rays: its own, or if it `refills`, as many as there are, which `next` counts. M: with
// StopRule::proven.
template <bool refills, Question question, class M, class Stored, class Grid>
__global__ void __launch_bounds__(rays_a_block, resident_threads_wanted<M> / rays_a_block)
    warp_kernel(const SceneView<Stored> scene, const Grid grid,
                const TypedRay<typename M::Real>* const listed, const std::uint64_t count, const HitName name,
                EyeHit* const hits, unsigned long long* const next) {
  static_assert(M::stop == StopRule::proven);
  using Real = typename M::Real;
  // So many lanes fetch at once, so that it pays to stop for it; and so often ways are cut, in turns.
  constexpr int enough = refills ? 12 : lanes_a_warp, cut_every = 4;
  __shared__ WarpRays<typename M::TestRay> block_rays[rays_a_block / lanes_a_warp];
  WarpRays<typename M::TestRay>& rays = block_rays[threadIdx.x / lanes_a_warp];
  const unsigned lane = threadIdx.x % lanes_a_warp;
  // In variables of the kernel's own: what holds references to itself would not stay in registers.
  LaneWalk<Real, Grid> own{{}, 0, lane, false};
  bool more = true, has_ray = false, own_rays = true;
  int turn = 0;
  const auto tell = [&] {
    const RayEnds<Real>& ends = rays.ends[lane];
    hits[ends.number] =
        answer<question>(scene, rays.nearest[lane], ends.t_max, ends.skipped, ends.scale, name);
  };
  for (;;) {
    const unsigned idle = __ballot_sync(all_lanes, !own.under_way);
    if (more && __popc(idle) >= enough) {
      std::uint64_t number = std::uint64_t{blockIdx.x} * rays_a_block + threadIdx.x;
      more = false;
      if constexpr (refills) {
        unsigned long long first = 0;
        if (lane == 0) first = atomicAdd(next, static_cast<unsigned long long>(__popc(idle)));
        first = __shfl_sync(all_lanes, first, 0);
        more = first + static_cast<unsigned>(__popc(idle)) < count;
        number = first + static_cast<unsigned>(__popc(idle & ((1U << lane) - 1)));
      }
      if (!own.under_way) {
        if (has_ray) tell();
        has_ray = number < count;
        if (has_ray) {
          ScaledRay<Real> ray = scaled(listed[number]);
          if constexpr (question == Question::blocked) ray.ray.t_max = 1 / ray.scale;
          ClippedRay<Real> near{};
          own.under_way = clip(ray.ray, cast<Real>(scene.clip), near);
          rays.ends[lane] = {ray.scale, near.skipped, near.ray.t_max, number};
          rays.nearest[lane] = {near.ray.t_max, 0};
          if (own.under_way) {
            prepare(rays.tests[lane], near.ray.origin, near.ray.direction);
            own.walk = Walk<Real, Grid>(grid, near);
            own.end = RealTraits<Real>::largest;
          }
        }
      }
      continue;
    }
    if (idle == all_lanes) break;
    if (refills && !more && ++turn >= cut_every && __popc(idle) >= lanes_a_warp / 2) {
      cut_ways(grid, ~idle, rays, own);
      turn = 0;
      own_rays = false;
      continue;
    }
    if (own.under_way) own.walk.enter(grid);
    test_lists<M>(scene, grid, own.ray, own.under_way ? own.walk.cell.list : empty_list, own_rays, rays);
    if (own.under_way) {
      own.under_way =
          !is_answered<question>(rays.nearest[own.ray], rays.ends[own.ray].t_max, own.walk.exit) &&
          own.walk.leave(grid) && (own_rays || own.walk.exit < own.end);
    }
  }
  if (has_ray) tell();
}

} // namespace masu
