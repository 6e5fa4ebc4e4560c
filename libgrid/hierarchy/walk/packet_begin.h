// A warp's rays begun as a packet (CUDA sources only). Where they are alike, as primary rays are, the upper
// nodes are visited once for all of them, four at a time, by a lane for each box: after Boulos, Wald &
// Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006. A box is passed over if
// no ray between the bounds of their origins and directions meets it. Of what is left each ray takes what it
// meets itself.
//
// A warp visits a node of one ray, or of 32, by some 500 instructions; four nodes for its packet by some 130.
//
// A plane's distance is off by less than 8 u M along its axis, and by one more where it is moved: less than
// in a ray's own visits (boxes.h). So no box is passed over of what a ray hits.
#pragma once

#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libscene/cuda/warp.h"

#include <limits>

namespace masu {

// What the origins and inverse directions of a warp's rays lie between, along one axis: reversed where they
// run towards lower numbers.
struct PacketAxis {
  float sign; // of all their directions
  float first_origin, last_origin, least_inverse, most_inverse;

  // For all lanes at once.
  __device__ PacketAxis(float origin, float inverse, bool has_ray) {
    constexpr int least = std::numeric_limits<std::int32_t>::min(), most = ~least;
    const auto bits = [&](float value) { return has_ray ? __float_as_int(value) : 0; };
    sign = __int_as_float(static_cast<int>(
        __reduce_or_sync(all_lanes, static_cast<unsigned>(bits(inverse < 0 ? -1.0F : 1.0F)))));
    // In the order of the floats; and the same function back.
    const auto ordered = [](int value) { return value ^ (value >> 31 & most); };
    const int from = ordered(bits(origin * sign)), speed = bits(inverse * sign);
    first_origin = __int_as_float(ordered(__reduce_min_sync(all_lanes, has_ray ? from : most)));
    last_origin = __int_as_float(ordered(__reduce_max_sync(all_lanes, has_ray ? from : least)));
    least_inverse = __int_as_float(__reduce_min_sync(all_lanes, has_ray ? speed : most));
    most_inverse = __int_as_float(__reduce_max_sync(all_lanes, speed));
  }

  // No ray enters before, and none leaves after.
  __device__ float entered(float near) const { return (near - last_origin) * least_inverse; }
  __device__ float left(float far) const { return (far - first_origin) * most_inverse; }
};

// A box with nodes that a packet meets: the planes that its rays meet first and last, along PacketAxis.
struct alignas(16) PacketBox {
  float near[3];
  std::uint32_t node;
  float far[3];
  float entry; // of the first ray
};
// A packet's, in shared memory: all of them that it has met.
using PacketBoxes = PacketBox[max_packet_boxes];
static_assert(max_packet_boxes == lanes_per_warp); // a lane, and a bit, for each

// The box of a slot along one axis.
__device__ inline void packet_planes(const HierarchyNode& node, unsigned slot, int axis,
                                     const PacketAxis& along, PacketBox& box) {
  const std::uint32_t low = slot < 4 ? node.low[axis][0] : node.low[axis][1],
                      high = slot < 4 ? node.high[axis][0] : node.high[axis][1];
  const float unit = float_of((node.exponents >> (8 * axis) & 0xff) << 23) * along.sign,
              origin = node.origin[axis] * along.sign;
  const auto plane = [&](std::uint32_t planes) {
    return fma(plane_of(planes, slot % 4) - plane_offset, unit, origin);
  };
  box.near[axis] = plane(along.sign < 0 ? high : low);
  box.far[axis] = plane(along.sign < 0 ? low : high);
}

// A warp's rays in the space of some boxes, where they are alike: the bounds of all of them.
struct PacketBounds {
  PacketAxis x, y, z;

  __device__ PacketBounds(const Vec3<float>& origin, const Vec3<float>& inverse, bool has_ray)
      : x(origin.x, inverse.x, has_ray), y(origin.y, inverse.y, has_ray), z(origin.z, inverse.z, has_ray) {}
};
__device__ inline bool are_alike(const Vec3<float>& inverse, bool has_ray) {
  const unsigned rays = __ballot_sync(all_lanes, has_ray);
  const auto alike = [&](float along) {
    const unsigned up = __ballot_sync(all_lanes, has_ray && along >= 0);
    return up == 0 || up == rays;
  };
  return alike(inverse.x) && alike(inverse.y) && alike(inverse.z);
}

// Looks from node `root` on into what a packet meets, and shows the visitor the references in the boxes of
// those with no more than max_leaves such boxes; others are left to the rays: they would be tested by all.
// Returns which of `boxes` are left, a bit each. `padding`: how far planes are moved outwards: in placed
// meshes, where nodes without boxes are items, which are left, too; and no more than max_left are left there.
// For all lanes at once, as all functions below.
template <int max_leaves, class Padding, class Visitor, class Show>
__device__ inline unsigned boxes_left(const HierarchyNode* nodes, std::uint32_t root, const PacketBounds& all,
                                      const Padding& padding, Visitor& visitor, bool has_ray,
                                      PacketBoxes& boxes, const Show& show,
                                      unsigned max_left = max_packet_boxes) {
  constexpr bool may_hold_items = !std::is_same_v<Padding, NoPadding>;
  const unsigned lane = threadIdx.x % lanes_per_warp;
  constexpr float most = RealTraits<float>::largest;
  if (lane == 0) boxes[0] = {{-most, -most, -most}, root, {most, most, most}, 0};
  __syncwarp();

  // The boxes before `visited` have been looked into; those with a bit in `left` are left to the rays.
  constexpr unsigned nodes_at_once = lanes_per_warp / boxes_per_node;
  const unsigned part = lane / boxes_per_node, slot = lane % boxes_per_node;
  unsigned visited = 0, met = 1, left = 0;
  while (visited < met) {
    const unsigned count = ::min(met - visited, nodes_at_once);
    const float farthest =
        __uint_as_float(__reduce_max_sync(all_lanes, has_ray ? __float_as_uint(visitor.farthest()) : 0));
    const HierarchyNode node = fetched(nodes + boxes[::min(visited + part, met - 1)].node);
    const std::uint32_t held = (slot < 4 ? node.slots[0] : node.slots[1]) >> slot % 4 * 8 & 0xff;
    const bool is_node = (held & node_slot) == node_slot;
    PacketBox box;
    packet_planes(node, slot, 0, all.x, box);
    packet_planes(node, slot, 1, all.y, box);
    packet_planes(node, slot, 2, all.z, box);
    if constexpr (may_hold_items) {
      for (int axis = 0; axis < 3; ++axis) {
        box.near[axis] -= padding;
        box.far[axis] += padding;
      }
    }
    std::uint32_t entry;
    const bool meets = overlap(all.x.entered(box.near[0]), all.x.left(box.far[0]), all.y.entered(box.near[1]),
                               all.y.left(box.far[1]), all.z.entered(box.near[2]), all.z.left(box.far[2]),
                               farthest, entry) &&
                       held != 0 && part < count;
    unsigned nodes_met = __ballot_sync(all_lanes, meets && is_node),
             leaves = __ballot_sync(all_lanes, meets && !is_node);
    const unsigned leaves_of_node = leaves >> part * boxes_per_node & 0xff;
    unsigned stay = __ballot_sync(all_lanes, __popc(leaves_of_node) > max_leaves);
    if constexpr (may_hold_items)
      stay |= __ballot_sync(all_lanes, (node.slots[0] | node.slots[1]) == 0 && part < count);
    nodes_met &= ~stay;
    leaves &= ~stay;
    const auto more = static_cast<unsigned>(__popc(nodes_met));
    if (met + more > max_packet_boxes) break;
    const unsigned staying =
        __ballot_sync(all_lanes, lane < count && (stay >> lane * boxes_per_node & 1) != 0) << visited;
    if constexpr (may_hold_items)
      if (static_cast<unsigned>(__popc(left | staying)) + met + more - visited - count > max_left) break;
    left |= staying;
    if ((nodes_met >> lane & 1) != 0) {
      box.node = node_in(node.first_node, node_slots(node), slot);
      box.entry = __uint_as_float(entry);
      boxes[met + rank_among(nodes_met, lane)] = box;
    }
    visited += count;
    met += more;
    for (; leaves != 0; leaves &= leaves - 1) {
      const int source = lowest_bit(leaves);
      const std::uint32_t first =
                              __shfl_sync(all_lanes, node.first_reference + references_begin(held), source),
                          references = __shfl_sync(all_lanes, references_in(held), source);
      if (!has_ray) continue;
      for (std::uint32_t i = 0; i < references; ++i)
        show(first + i);
    }
    __syncwarp();
  }
  if (visited < met) left |= ~0U << visited & ~0U >> (lanes_per_warp - met);
  return left;
}

// Whether a ray meets one of a packet's boxes, and where.
__device__ inline bool meets(const PacketBox& box, const Vec3<float>& origin, const Vec3<float>& inverse,
                             float farthest, std::uint32_t& entry) {
  const auto own = [](float plane, float from, float along) {
    return ((along < 0 ? -plane : plane) - from) * along;
  };
  return overlap(own(box.near[0], origin.x, inverse.x), own(box.far[0], origin.x, inverse.x),
                 own(box.near[1], origin.y, inverse.y), own(box.far[1], origin.y, inverse.y),
                 own(box.near[2], origin.z, inverse.z), own(box.far[2], origin.z, inverse.z), farthest,
                 entry);
}

// What is left to the rays, from far to near: each remembers what it meets itself, and what comes last is
// taken first.
template <class Visitor>
__device__ inline void remember_boxes(unsigned left, const PacketBoxes& boxes, const Vec3<float>& origin,
                                      HierarchyWalk<float>& walk, HierarchyStack& stack, Visitor& visitor,
                                      bool has_ray) {
  const unsigned lane = threadIdx.x % lanes_per_warp;
  std::uint32_t key = (left >> lane & 1) != 0 ? (__float_as_uint(boxes[lane].entry) & ~31U) | lane : 0;
  for (; left != 0; left &= left - 1) {
    const std::uint32_t next = __reduce_max_sync(all_lanes, key) % lanes_per_warp;
    if (lane == next) key = 0;
    const PacketBox box = boxes[next];
    std::uint32_t entry;
    if (has_ray && meets(box, origin, walk.inverse, visitor.farthest(), entry))
      push(stack, walk.height, nodes_group(box.node, 1, 1, entry & ~MetBoxes::slot_bits));
  }
}

// Begins the walks of a warp's rays, of which there is one at least; as HierarchyWalk::advance() false for
// rays at their end, and for lanes without a ray. Rays that aren't alike begin at the root.
template <int max_leaves, class Hierarchy, class Visitor>
__device__ inline bool begin_packet(const Hierarchy& hierarchy, HierarchyWalk<float>& walk,
                                    HierarchyStack& stack, Visitor& visitor, bool has_ray,
                                    PacketBoxes& boxes) {
  const Vec3<float> origin = visitor.ray.origin, inverse = walk.inverse;
  if (!are_alike(inverse, has_ray)) return has_ray;
  const PacketBounds all(origin, inverse, has_ray);
  const unsigned left =
      boxes_left<max_leaves>(hierarchy.nodes, 0, all, NoPadding{}, visitor, has_ray, boxes,
                             [&](std::uint32_t reference) { show(hierarchy, reference, visitor); });
  walk.next = walk.no_node;
  remember_boxes(left, boxes, origin, walk, stack, visitor, has_ray);
  return has_ray && !visitor.ends() && walk.go_back(stack, visitor.farthest());
}

} // namespace masu
