// A warp's rays through placed meshes begun as packets (CUDA sources only): one above the placements, and,
// from the nearest placement on that its rays meet, one more in that mesh, of the rays that meet it
// (packet_begin.h).
#pragma once

#include "libgrid/hierarchy/walk/packet_begin.h"
#include "libgrid/placed/placed_walk.h"

namespace masu {

// Boxes that both leave on the stack, at most, and of these the one above. Beside them there is a mark, and
// what a mesh's hierarchy takes; or beside those above all that is taken above.
inline constexpr unsigned max_boxes_left = max_packet_boxes - 1, max_boxes_left_above = 10;
static_assert(2 * max_hierarchy_depth + max_boxes_left + 1 <= max_stack_height);
static_assert(2 * max_hierarchy_depth + max_boxes_left_above + max_upper_levels + 1 <= max_stack_height);

// As that of a single hierarchy. Rays that don't all begin at the same root begin by themselves.
template <int max_leaves, class Stored, class Visitor>
__device__ inline bool begin_packet(const PlacedRay<Stored>& seen, PlacedWalk<float>& walk,
                                    HierarchyStack& stack, Visitor& visitor, bool has_ray,
                                    PacketBoxes& boxes) {
  constexpr std::uint32_t no_node = HierarchyWalk<float>::no_node;
  const PlacedView<Stored>& placed = seen.placed;
  HierarchyWalk<float>& level = walk.level();
  const bool begins = has_ray && level.next != no_node;
  if (!__any_sync(all_lanes, begins)) return false;
  const std::uint32_t root = __reduce_max_sync(all_lanes, begins ? level.next : 0);
  const bool has_levels = node_slots(placed.upper_nodes[root]) != 0; // or the root is an item
  if (__any_sync(all_lanes, begins && (level.next != root || level.height != 0)) ||
      (has_levels && !are_alike(level.inverse, begins)))
    return begins;
  const unsigned lane = threadIdx.x % lanes_per_warp;
  PacketBox item; // that is entered next
  std::uint32_t from = root;
  bool is_in = begins; // among the boxes below `from`
  for (bool is_above = has_levels;; is_above = false) {
    if (!is_above) {
      if (has_levels) {
        std::uint32_t entry;
        is_in = begins && meets(item, walk.origin, level.inverse, visitor.farthest(), entry);
        if (is_in) level.next = item.node;
      }
      HierarchyNode node;
      is_in = is_in && walk.comes_to_node(seen, stack, visitor, node);
      if (!__any_sync(all_lanes, is_in)) break;
      if (!are_alike(level.inverse, is_in)) {
        if (is_in) return true;
        break;
      }
      from = __reduce_max_sync(all_lanes, is_in ? level.next : 0);
    }
    const float outwards =
        __uint_as_float(__reduce_max_sync(all_lanes, is_in ? __float_as_uint(walk.padding()) : 0));
    unsigned left = boxes_left<max_leaves>(
        is_above ? placed.upper_nodes : placed.of_meshes.nodes, from,
        PacketBounds(walk.origin, level.inverse, is_in), outwards, visitor, is_in, boxes,
        [&](std::uint32_t leaf) { walk.show_reference(seen, leaf, visitor); },
        is_above     ? max_boxes_left_above
        : has_levels ? max_boxes_left - max_boxes_left_above
                     : max_boxes_left);
    if (is_in) level.next = no_node;
    const std::uint32_t key =
        (left >> lane & 1) != 0 ? (__float_as_uint(boxes[lane].entry) & ~31U) | lane : 0x7fffffffU;
    item = boxes[__reduce_min_sync(all_lanes, key) % lanes_per_warp];
    const bool enters = is_above && left != 0 && node_slots(placed.upper_nodes[item.node]) == 0;
    if (enters) left &= ~(1U << __reduce_min_sync(all_lanes, key) % lanes_per_warp);
    remember_boxes(left, boxes, walk.origin, level, stack, visitor, is_in);
    if (!enters) break;
    __syncwarp();
  }
  return begins && !visitor.ends() && walk.comes_back(stack, visitor);
}

} // namespace masu
