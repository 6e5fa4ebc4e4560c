// Walks through a bounding volume hierarchy by groups of lanes (CUDA sources only): 2 or 4 lanes of a warp
// hold the same ray and the same walk, and share the boxes of its nodes and its tests of primitives.
//
// A warp takes as long to visit a node of one ray as to visit nodes of 32. A warp's rays end at different
// times, and once 16 of them are left, half of its lanes would idle until the longest is done.
#pragma once

#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libscene/cuda/warp.h"

namespace masu {

// A ray under way: what one lane has of it, or each lane of a group.
template <class TestRay, class Walk>
struct WalkingRay {
  using Real = typename TestRay::Real;
  TestRay test_ray;
  Walk walk;
  Hit<Real> nearest;
  std::uint32_t thread; // of the block, by which it was begun
};

// Moves a warp's rays to groups of 2^log2 lanes. `holders`: one lane of each ray, a bit each; no more than
// there are groups. `sources`: room for a number per lane, of the warp's alone. Returns whether the lane has
// a ray then. For all lanes of the warp at once, as all functions below.
template <int log2, class Walking>
__device__ inline bool regroup(unsigned holders, Walking& own, HierarchyStack& stack,
                               std::uint32_t* sources) {
  const unsigned lane = threadIdx.x % lanes_per_warp, group = lane >> log2;
  const bool holds = (holders >> lane & 1) != 0;
  __syncwarp();
  if (holds) sources[rank_among(holders, lane)] = lane;
  __syncwarp();
  const bool has_ray = group < static_cast<unsigned>(__popc(holders));
  const int source = static_cast<int>(sources[has_ray ? group : 0]);
  const int highest = __reduce_max_sync(all_lanes, holds ? own.walk.level().height : 0);
  own = from_lane(own, source);
  for (int i = 0; i < highest; ++i)
    stack[i] = from_lane(stack[i], source);
  return has_ray;
}

// What the ray meets of the boxes that lane `sub` of its group tests: one of every 2^log2 slots.
template <int log2, class Real, class Padding>
__device__ inline MetBoxes boxes_met_by_lane(const HierarchyNode& node, const Vec3<Real>& origin,
                                             const Vec3<Real>& inverse, Real t_max, const Padding& padding,
                                             unsigned sub) {
  const PaddedAxes<Real> axes = padded(node_axes(node, origin, inverse), inverse, padding);
  const NodeAxes<Real>&near = axes.near, &far = axes.far;
  const bool up_x = inverse.x >= 0, up_y = inverse.y >= 0, up_z = inverse.z >= 0;
  MetBoxes met;
#pragma unroll
  for (unsigned first = 0; first < boxes_per_node; first += 1 << log2) {
    const unsigned half = first / 4, byte = first % 4 + sub, slot = first + sub;
    const auto plane = [&](const std::uint32_t(&low)[2], const std::uint32_t(&high)[2], bool is_low,
                           const NodeAxis<Real>& axis) {
      const std::uint32_t planes = is_low ? low[half] : high[half];
      return fma(plane_of(planes, byte), axis.scale, axis.start);
    };
    std::uint32_t entry;
    if (!overlap(
            plane(node.low[0], node.high[0], up_x, near.x), plane(node.low[0], node.high[0], !up_x, far.x),
            plane(node.low[1], node.high[1], up_y, near.y), plane(node.low[1], node.high[1], !up_y, far.y),
            plane(node.low[2], node.high[2], up_z, near.z), plane(node.low[2], node.high[2], !up_z, far.z),
            t_max, entry))
      continue;
    const std::uint32_t held = node.slots[half] >> (8 * byte) & 0xff;
    met.bits |= met_bits(held);
    if ((held & node_slot) == node_slot) met.enter((entry & ~MetBoxes::slot_bits) | slot);
  }
  return met;
}

// What all lanes of each group have met, to each of them.
template <int log2, bool by_distance>
__device__ inline void join_lanes(MetBoxes& met) {
#pragma unroll
  for (int step = 0; step < log2; ++step) {
    met.bits |= __shfl_xor_sync(all_lanes, met.bits, 1 << step);
    if constexpr (!by_distance) continue;
    const std::uint32_t nearest = __shfl_xor_sync(all_lanes, met.nearest, 1 << step),
                        second = __shfl_xor_sync(all_lanes, met.second, 1 << step);
    met.second = ::min(::max(met.nearest, nearest), ::min(met.second, second));
    met.nearest = ::min(met.nearest, nearest);
  }
}
// The nearest hit, of NearestHit and of AnyHit.
template <int log2>
__device__ inline void join_lanes(Hit<float>& hit) {
  std::uint64_t key = hit_key(hit);
#pragma unroll
  for (int step = 0; step < log2; ++step)
    key = ::min(key, __shfl_xor_sync(all_lanes, key, 1 << step));
  hit = hit_of(key);
}
template <int log2>
__device__ inline void join_lanes(float& t) {
#pragma unroll
  for (int step = 0; step < log2; ++step)
    t = fast_min(t, __shfl_xor_sync(all_lanes, t, 1 << step));
}

// Goes on with the ray of the lane's group, as advance() does; false at its end, and for lanes without a ray.
template <int log2, class Walk, class Structure, class Visitor>
__device__ inline bool advance_group(Walk& walk, const Structure& structure, HierarchyStack& stack,
                                     Visitor& visitor, bool has_ray) {
  constexpr unsigned lanes = 1U << log2;
  const unsigned sub = threadIdx.x % lanes;
  auto& level = walk.level();
  HierarchyNode node{};
  const bool visits = has_ray && walk.comes_to_node(structure, stack, visitor, node);
  MetBoxes met;
  if (visits)
    met = boxes_met_by_lane<log2>(node, walk.origin_of(visitor.ray), level.inverse, visitor.farthest(),
                                  walk.padding(), sub);
  join_lanes<log2, needs_order<Visitor>>(met);
  if (visits) level.template enter<needs_order<Visitor>>(node, met, stack);
  if (!has_ray) level.references.bits = 0;
  while (__any_sync(all_lanes, level.references.bits != 0)) {
    // Each lane takes another of the first references.
    std::uint32_t bits = level.references.bits;
#pragma unroll
    for (unsigned i = 0; i < lanes; ++i) {
      if (i < sub) bits &= bits - 1;
      level.references.bits &= level.references.bits - 1;
    }
    if (bits != 0)
      walk.show_reference(structure, level.references.first + static_cast<std::uint32_t>(lowest_bit(bits)),
                          visitor);
    join_lanes<log2>(visitor.hit);
  }
  return has_ray && !visitor.ends() && walk.comes_back(stack, visitor);
}

} // namespace masu
