// Rays through a bounding volume hierarchy (CUDA sources only): a thread each, whose warp may fetch the
// list's next rays for its idle lanes; after Aila & Laine, "Understanding the Efficiency of Ray Traversal on
// GPUs", HPG 2009, and, for when to fetch, Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs", HPG 2017. A warp's first rays begin as a packet (packet_begin.h), and
// its last ones are traced by groups of its lanes (lane_groups.h).
#pragma once

#include "libgrid/hierarchy/walk/lane_groups.h"
#include "libgrid/hierarchy/walk/packet_begin.h"
#include "libgrid/hierarchy/walk/walks_in_use.h"
#include "renderer/cuda/rays/loop_choice.h"
#include "renderer/cuda/rays/straggler_queue.h"
#include "renderer/cuda/rays/warp_rays.h"

namespace masu {

// Lanes fetch rays once so many lane steps were idle: lanes beyond idle_lanes_tolerated, summed over steps;
// and then as long as rays miss the scene, until no more than max_lanes_wanting are left without one.
inline constexpr int max_idle_steps = 4, idle_lanes_tolerated = 4, max_lanes_wanting = 8;

// Short rays are fetched so often that warps queue up at the list's counter. So a warp takes more of them
// than it wants as long as there are plenty for each, so many that in the end all warps are done at the same
// time.
inline constexpr unsigned rays_in_advance = 96, plenty_for_a_warp = 256;

// Of a warp that has no more rays to fetch, so many are traced by groups of 2 and of 4 lanes. By 8 lanes a
// step takes no fewer instructions than by 4.
inline constexpr int max_rays_by_pairs = lanes_per_warp / 2, max_rays_by_fours = max_rays_by_pairs / 2;

// What a kernel needs to know of how rays walk through a hierarchy. Those through placed meshes walk another
// way (placed_rays.h).
template <class Hierarchy>
struct WalksThrough {
  template <class Real>
  using Walk = HierarchyWalk<Real>;
  template <class M>
  static constexpr int packet_threads_wanted = resident_threads_wanted<M>;
  // Of a warp, which groups of lanes trace: where its rays began as a packet, and where it fetched them.
  static constexpr int last_of_packet = max_rays_by_pairs, last_fetched = max_rays_by_pairs;
};
template <class M>
constexpr int by_groups(int rays) {
  return walks_in_use::lane_groups && std::is_same_v<typename M::Real, float> ? rays : 0;
}
template <class M, class Hierarchy>
using RayThrough =
    WalkingRay<typename M::TestRay, typename WalksThrough<Hierarchy>::template Walk<typename M::Real>>;
template <class Hierarchy>
__device__ inline const Hierarchy& seen_by_rays(const Hierarchy& hierarchy) {
  return hierarchy;
}

// Where the list's rays begin with that of a number.
template <class Hierarchy>
const Hierarchy& from_ray(const Hierarchy& hierarchy, std::uint64_t) {
  return hierarchy;
}

// Goes on with a ray by `advance`, which is given the visitor of its query; false at its end.
template <Query query, class M, class Stored, class Walking, class Advance>
__device__ inline bool goes_on(const SceneView<Stored>& scene, Walking& ray,
                               const RayEnds<typename M::Real>& end, const Advance& advance) {
  NoCounts counts;
  if constexpr (query == Query::nearest_hit) {
    // 0: t_max is for the rule of termination, which only grids use.
    NearestHit<M, Stored, NoCounts> visitor{scene, ray.test_ray, counts, end.t_min, 0, ray.nearest};
    const bool is_under_way = advance(visitor);
    ray.nearest = visitor.hit;
    return is_under_way;
  } else {
    AnyHit<M, Stored, NoCounts> visitor{scene, ray.test_ray, counts, end.t_min, end.t_max, ray.nearest.t};
    const bool is_under_way = advance(visitor);
    ray.nearest.t = visitor.hit;
    return is_under_way;
  }
}

template <Query query, class Real>
__device__ inline void write_end(const RayResults& results, const RayEnds<Real>& end,
                                 const Hit<Real>& nearest) {
  write_hit<query>(results, end.number, reported(nearest, end.t_max, end.skipped, end.scale));
}

// Traces a warp's rays by groups of 2^log2 lanes until no more than `left_over` of them are under way, and
// returns one lane of each. `holders`, too, is one lane of each ray.
template <int log2, int left_over, Query query, class M, class Stored, class Hierarchy>
__device__ inline unsigned trace_by_groups(const SceneView<Stored>& scene, const Hierarchy& hierarchy,
                                           unsigned holders, RayThrough<M, Hierarchy>& own,
                                           HierarchyStack& stack, const RayEnds<typename M::Real>* ends,
                                           std::uint32_t* sources, const RayResults& results) {
  if (__popc(holders) <= left_over) return holders;
  bool has_ray = regroup<log2>(holders, own, stack, sources);
  const bool is_first = threadIdx.x % (1U << log2) == 0;
  do {
    const auto& end = ends[own.thread];
    const bool had_ray = has_ray;
    has_ray = goes_on<query, M>(scene, own, end, [&](auto& visitor) {
      return advance_group<log2>(own.walk, seen_by_rays(hierarchy), stack, visitor, had_ray);
    });
    if (had_ray && !has_ray && is_first) write_end<query>(results, end, own.nearest);
    holders = __ballot_sync(all_lanes, has_ray && is_first);
  } while (__popc(holders) > left_over);
  return holders;
}

// Clips ray `number` of the list; false where it misses the scene's bounds, which is written, or there is
// none.
template <Query query, class Real, class Stored>
__device__ inline bool fetch_ray(const SceneView<Stored>& scene, const Ray<Real>* rays, std::uint32_t count,
                                 std::uint32_t number, const RayResults& results, RayEnds<Real>& end,
                                 ClippedRay<Real>& near) {
  if (number >= count) return false;
  Real scale;
  if (!scale_and_clip(scene, streamed(rays + number), near, scale, end.t_min)) {
    write_hit<query>(results, number, no_hit());
    return false;
  }
  end.scale = scale;
  end.skipped = near.skipped;
  end.t_max = near.ray.t_max;
  end.number = number;
  return true;
}
template <class Hierarchy, class TestRay>
__device__ inline void
begin_ray(const Hierarchy&, const ClippedRay<typename TestRay::Real>& near, std::uint32_t,
          WalkingRay<TestRay, HierarchyWalk<typename TestRay::Real>>& own, HierarchyStack&) {
  own.nearest = {near.ray.t_max, 0};
  prepare(own.test_ray, near.ray.origin, near.ray.direction);
  own.walk.begin(near);
}

// Goes on with a warp's last rays, no more than `last` and each of one of its lanes, by groups of lanes.
template <int last, Query query, class M, class Stored, class Hierarchy>
__device__ inline void trace_last_rays(const SceneView<Stored>& scene, const Hierarchy& hierarchy,
                                       bool has_ray, RayThrough<M, Hierarchy>& own, HierarchyStack& stack,
                                       const RayEnds<typename M::Real>* ends, std::uint32_t* sources,
                                       const RayResults& results) {
  if constexpr (last != 0) {
    std::uint32_t* const warp_sources = sources + threadIdx.x / lanes_per_warp * lanes_per_warp;
    unsigned left = __ballot_sync(all_lanes, has_ray);
    if constexpr (last > max_rays_by_fours)
      left = trace_by_groups<1, max_rays_by_fours, query, M>(scene, hierarchy, left, own, stack, ends,
                                                             warp_sources, results);
    trace_by_groups<2, 0, query, M>(scene, hierarchy, left, own, stack, ends, warp_sources, results);
  }
}

// Boxes of references of a node that a packet tests: triangles' are small beside a packet, and many.
template <class M>
constexpr int max_packet_leaves = M::kinds == with_triangles ? 1 : 2;

// Traces a list of rays, a thread each; a warp's begin as a packet.
template <Query query, class M, class Stored, class Hierarchy>
__global__ void __launch_bounds__(rays_per_block,
                                  WalksThrough<Hierarchy>::template packet_threads_wanted<M> / rays_per_block)
    packet_kernel(const SceneView<Stored> scene, const __grid_constant__ Hierarchy hierarchy,
                  const Ray<typename M::Real>* const rays, const std::uint32_t count,
                  const RayResults results, const RayLoop* const chosen) {
  if (!is_chosen(RayLoop::thread_per_ray, chosen)) return;
  // What is needed of a ray when it is begun and ended would take up registers.
  __shared__ RayEnds<typename M::Real> ends[rays_per_block];
  __shared__ std::uint32_t sources[rays_per_block]; // of regroup()
  __shared__ PacketBoxes packets[rays_per_block / lanes_per_warp];
  auto& end = ends[threadIdx.x];
  constexpr int max_last_rays = by_groups<M>(WalksThrough<Hierarchy>::last_of_packet);
  HierarchyStack stack;
  RayThrough<M, Hierarchy> own{};
  own.thread = threadIdx.x;
  const std::uint32_t number = blockIdx.x * rays_per_block + threadIdx.x;
  ClippedRay<typename M::Real> near{};
  const bool has_ray = fetch_ray<query>(scene, rays, count, number, results, end, near);
  if (!__any_sync(all_lanes, has_ray)) return;
  if (has_ray) begin_ray(hierarchy, near, number, own, stack);
  bool under_way = goes_on<query, M>(scene, own, end, [&](auto& visitor) {
    if constexpr (!walks_in_use::packet_begin) return has_ray;
    return begin_packet<max_packet_leaves<M>>(seen_by_rays(hierarchy), own.walk, stack, visitor, has_ray,
                                              packets[threadIdx.x / lanes_per_warp]);
  });
  if (__popc(__ballot_sync(all_lanes, under_way)) > max_last_rays) {
    while (under_way) {
      under_way = goes_on<query, M>(scene, own, end, [&](auto& visitor) {
        return own.walk.advance(seen_by_rays(hierarchy), stack, visitor);
      });
      if (__popc(__activemask()) <= max_last_rays) break;
    }
  }
  if (has_ray && !under_way) write_end<query>(results, end, own.nearest);
  __syncwarp(); // for `ends`, which other lanes read now
  trace_last_rays<max_last_rays, query, M>(scene, hierarchy, under_way, own, stack, ends, sources, results);
}

// Traces a list of rays, of which warps fetch the next ones for their idle lanes from `next_ray` on.
template <Query query, class M, class Stored, class Hierarchy>
__global__ void __launch_bounds__(rays_per_block, resident_threads_wanted<M> / rays_per_block)
    refill_kernel(const SceneView<Stored> scene, const __grid_constant__ Hierarchy hierarchy,
                  const Ray<typename M::Real>* const rays, const std::uint32_t count,
                  const RayResults results, std::uint32_t* const next_ray, const RayLoop* const chosen) {
  if (!is_chosen(RayLoop::warp_refill, chosen)) return;
  __shared__ RayEnds<typename M::Real> ends[rays_per_block];
  __shared__ std::uint32_t sources[rays_per_block];
  const unsigned lane = threadIdx.x % lanes_per_warp;
  auto& end = ends[threadIdx.x];
  constexpr int max_last_rays = by_groups<M>(WalksThrough<Hierarchy>::last_fetched);
  HierarchyStack stack;
  RayThrough<M, Hierarchy> own{};
  own.thread = threadIdx.x;
  const std::uint32_t plenty = plenty_for_a_warp * (rays_per_block / lanes_per_warp) * gridDim.x;
  bool has_ray = false, under_way = false;
  std::uint32_t next = 0, taken = 0; // the rays from `next` to `taken` are the warp's
  for (;;) {
    unsigned idle = __ballot_sync(all_lanes, !under_way);
    // By the lanes that fetch the next ones, more than end at the same time.
    if (has_ray && !under_way) {
      write_end<query>(results, end, own.nearest);
      has_ray = false;
    }
    if (next < count && idle != 0) {
      ClippedRay<typename M::Real> near{};
      do {
        const auto wanting = static_cast<unsigned>(__popc(idle));
        if (next == taken) {
          const unsigned taking = wanting + (next + plenty < count ? rays_in_advance : 0);
          next = add_for_warp(*next_ray, static_cast<int>(taking));
          taken = next + taking;
        }
        const std::uint32_t number = next + rank_among(idle, lane);
        if (!has_ray && number < taken)
          has_ray = fetch_ray<query>(scene, rays, count, number, results, end, near);
        next = ::min(next + wanting, taken);
        idle = __ballot_sync(all_lanes, !has_ray);
      } while (next < count && __popc(idle) > max_lanes_wanting);
      if (has_ray && !under_way) // all that were fetched, at once
        begin_ray(hierarchy, near, end.number, own, stack);
      under_way = has_ray;
    }
    if (next >= count && __popc(~idle) <= max_last_rays) break;
    int idle_steps = 0;
    while (under_way) {
      under_way = goes_on<query, M>(scene, own, end, [&](auto& visitor) {
        return own.walk.advance(seen_by_rays(hierarchy), stack, visitor);
      });
      const int active = __popc(__activemask());
      if (next < count) {
        idle_steps += max(lanes_per_warp - idle_lanes_tolerated - active, 0);
        if (idle_steps >= max_idle_steps) break;
      } else if (active <= max_last_rays) {
        break;
      }
    }
    __syncwarp();
  }
  __syncwarp();
  trace_last_rays<max_last_rays, query, M>(scene, hierarchy, under_way, own, stack, ends, sources, results);
}

} // namespace masu
