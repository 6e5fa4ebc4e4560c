// The walk of one ray, on any processor: the one that defines what is visited and counted. After Ylitie,
// Karras & Laine (hierarchy.h).
#pragma once

#include "libgrid/grid/grid_walk.h"
#include "libgrid/hierarchy/walk/boxes.h"

namespace masu {

MASU_HD inline int lowest_bit(std::uint32_t bits) { // of a number other than 0
#ifdef __CUDA_ARCH__
  return __ffs(static_cast<int>(bits)) - 1;
#else
  return std::countr_zero(bits);
#endif
}

// What is still to be visited. Nodes: from `first` on, by their slots in the highest 8 bits and the slots of
// all that there are in the lowest 8; between them 13 bits of where the ray enters the nearest of them and 3
// of its slot. Or references: from `first` on, by the bits below 24, where no bit above is set.
struct HierarchyGroup {
  std::uint32_t first, bits;

  MASU_HD bool has_nodes() const { return bits > 0xffffff; }
  // Rounded down.
  MASU_HD float entry() const { return float_of((bits & 0xfff800) << 7); }
  // The nearest as long as it is still to be visited, then the others by number.
  MASU_HD std::uint32_t next_slot() const {
    const std::uint32_t nearest = bits >> 8 & 7;
    return (bits >> (24 + nearest) & 1) != 0 ? nearest : static_cast<std::uint32_t>(lowest_bit(bits >> 24));
  }
};
MASU_HD inline HierarchyGroup nodes_group(std::uint32_t first, std::uint32_t slots, std::uint32_t all,
                                          std::uint32_t nearest) {
  return {first, slots << 24 | (nearest >> 7 & 0xfff800) | (nearest & MetBoxes::slot_bits) << 8 | all};
}

// Where to find the node of a slot among a node's.
MASU_HD inline std::uint32_t node_in(std::uint32_t first, std::uint32_t held, std::uint32_t slot) {
  return first + count_bits(held & ~(~0U << slot));
}

// Boxes that rays begun as a packet (renderer/cuda/packet.h) have met by then, at most: a warp's lanes.
inline constexpr unsigned max_packet_boxes = 32;

// What a walk comes back to. A node pushes at most what it holds besides the node visited next, and the tests
// put off; before them there may be a packet's boxes. It isn't part of the walk: a struct that holds an array
// which is indexed lies in memory as a whole, where registers should hold the rest.
inline constexpr int max_stack_height = 2 * max_hierarchy_depth + max_packet_boxes;
using HierarchyStack = HierarchyGroup[max_stack_height];

MASU_HD inline void push(HierarchyStack& stack, int& height, const HierarchyGroup& group) {
#ifndef __CUDA_ARCH__
  // There is room, but while a mapped file changes: then results are thrown away.
  if (height == max_stack_height) height = 0;
#endif
  stack[height++] = group;
}

template <class Real, class Visitor>
MASU_HD inline void show(const HierarchyView<Real>& hierarchy, std::uint32_t reference, Visitor& visitor) {
  visitor.primitive(hierarchy.references[reference]);
}
template <class Real, class Stored, class Visitor>
MASU_HD inline void show(const LeafHierarchyView<Real, Stored>& hierarchy, std::uint32_t reference,
                         Visitor& visitor) {
  visitor.leaf(hierarchy.leaves + reference);
}

// Whether what a visitor is shown first matters to it: not where it ends with any hit.
template <class Visitor>
constexpr bool needs_order = !requires(const Visitor& visitor) {
  visitor.found();
};

struct NoMarks {}; // on the stack: empty groups, of which only walks through placed meshes have any

// A walk under way.
template <class Real>
struct HierarchyWalk {
  static constexpr std::uint32_t no_node = ~0U;

  Vec3<Real> inverse; // bounded
  std::uint32_t next; // node to visit
  HierarchyGroup references;
  int height; // of the stack

  MASU_HD void begin(const ClippedRay<Real>& near) {
    inverse = bounded_inverse(near);
    keep(inverse.x);
    keep(inverse.y);
    keep(inverse.z);
    next = 0;
    references = {0, 0};
    height = 0;
  }

  // After a node was visited: the references in the boxes that the ray meets, and as the next node the one
  // that it enters first. Of the others the one that it enters first comes next, and none of them once all
  // are entered beyond the nearest hit. Where any hit will do they come by their slots, which takes less.
  template <bool by_distance>
  MASU_HD void enter(const HierarchyNode& node, const MetBoxes& met, HierarchyStack& stack) {
    const std::uint32_t nodes = met.bits >> 24;
    references = {node.first_reference, met.bits & 0xffffff};
    next = no_node;
    if (nodes == 0) return;
    const auto first = [](std::uint32_t slots, std::uint32_t nearest) {
      return by_distance ? nearest : static_cast<std::uint32_t>(lowest_bit(slots));
    };
    const std::uint32_t slot = first(nodes, met.nearest) & MetBoxes::slot_bits,
                        others = nodes & ~(1U << slot);
    next = node_in(node.first_node, node_slots(node), slot);
    if (others != 0)
      push(stack, height, nodes_group(node.first_node, others, node_slots(node), first(others, met.second)));
  }

  // Goes back for a node that the ray enters no farther than `farthest`, or for references, where there is no
  // next node; false at the end.
  // `passes_mark`: what to do at an empty group; false at the end.
  template <class Limit, class PassesMark = NoMarks>
  MASU_HD bool go_back(HierarchyStack& stack, Limit farthest, const PassesMark& passes_mark = {}) {
    references.bits = 0;
    while (next == no_node) {
      if (height == 0) return false;
      HierarchyGroup group = stack[--height];
      if (!group.has_nodes()) {
        if constexpr (!std::is_same_v<PassesMark, NoMarks>)
          if (group.bits == 0) {
            if (!passes_mark()) return false;
            continue;
          }
        references = group;
        break;
      }
      if (!(group.entry() <= farthest)) continue;
      const std::uint32_t slot = group.next_slot();
      next = node_in(group.first, group.bits & 0xff, slot);
      group.bits &= ~(0x1000000U << slot);
      if (group.has_nodes()) push(stack, height, group);
    }
    return true;
  }

  // What groups of lanes ask of a walk (lane_groups.h); that through placed meshes has other answers
  // (libgrid/placed/placed_walk.h).
  MASU_HD HierarchyWalk& level() { return *this; }
  template <class Hierarchy, class Visitor>
  MASU_HD bool comes_to_node(const Hierarchy& hierarchy, HierarchyStack&, Visitor&, HierarchyNode& node) {
    if (next == no_node) return false;
    node = fetched(hierarchy.nodes + next);
    return true;
  }
  template <class TestRay>
  MASU_HD const Vec3<Real>& origin_of(const TestRay& ray) const {
    return ray.origin;
  }
  MASU_HD NoPadding padding() const { return {}; }
  template <class Hierarchy, class Visitor>
  MASU_HD void show_reference(const Hierarchy& hierarchy, std::uint32_t reference, Visitor& visitor) const {
    show(hierarchy, reference, visitor);
  }
  template <class Visitor>
  MASU_HD bool comes_back(HierarchyStack& stack, Visitor& visitor) {
    return go_back(stack, visitor.farthest());
  }

  // Calls show(number) for the references. Tests are put off where few of a warp's lanes have any (after
  // Ylitie, Karras & Laine), unless the visitor counts: what is visited would depend on that.
  template <class Visitor, class Show>
  MASU_HD void show_references([[maybe_unused]] HierarchyStack& stack,
                               [[maybe_unused]] const Visitor& visitor, const Show& show) {
#ifdef __CUDA_ARCH__
    const int testing = __popc(__activemask());
#endif
    while (references.bits != 0) {
#ifdef __CUDA_ARCH__
      if (!visitor.counts.is_counted && __popc(__activemask()) * 4 < testing) {
        push(stack, height, references);
        break;
      }
#endif
      const int reference = lowest_bit(references.bits);
      references.bits &= references.bits - 1;
      show(references.first + static_cast<std::uint32_t>(reference));
    }
  }

  // Visits the next node of the visitor's ray, and shows the visitor the references in the boxes that the ray
  // meets; false at the end.
  template <class Hierarchy, class Visitor>
  MASU_HD bool advance(const Hierarchy& hierarchy, HierarchyStack& stack, Visitor& visitor) {
    if (next != no_node) {
#ifdef __CUDA_ARCH__
      const HierarchyNode node = fetched(hierarchy.nodes + next);
#else
      const HierarchyNode& node = hierarchy.nodes[next];
#endif
      const MetBoxes met = boxes_met(node, visitor.ray.origin, inverse, visitor.farthest());
      visitor.counts.cell(met.bits == 0);
      if constexpr (records_walk<std::decay_t<decltype(visitor.counts)>>)
        visitor.counts.visited(next, node, visitor.ray.origin, inverse, visitor.farthest(), met);
      enter<needs_order<Visitor>>(node, met, stack);
    }
    show_references(stack, visitor, [&](std::uint32_t reference) { show(hierarchy, reference, visitor); });
    return !visitor.ends() && go_back(stack, visitor.farthest());
  }
};

template <class Real, class Hierarchy, class Visitor>
MASU_HD inline void walk_hierarchy(const Hierarchy& hierarchy, const ClippedRay<Real>& near,
                                   Visitor& visitor) {
  HierarchyStack stack;
  HierarchyWalk<Real> walk{};
  walk.begin(near);
  while (walk.advance(hierarchy, stack, visitor)) {
  }
}

} // namespace masu
