// A bounding volume hierarchy as tracing sees it: where its arrays lie, on the host or on the device. Passed
// by value.
//
// It is the other way to hold a scene's references: where a grid divides space, and a ray steps through what
// is empty, a hierarchy bounds what is there. Nodes hold up to eight boxes, compressed to 8 bits per plane,
// after Ylitie, Karras & Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs",
// HPG 2017.
#pragma once

#include "libscene/base/fetch.h"
#include "libscene/geometry/box.h"
#include "libscene/geometry/intersect.h"

#include <cmath>

namespace masu {

// Boxes are in units of `exponent`'s power of two per axis, counted from `origin`. A slot of a node holds one
// of the boxes, and what is in it:
//
//   0                   nothing
//   0x38 | slot         a node: `first_node` and so many after it as lower slots hold nodes
//   unary << 5 | first  references: as many as `unary` (1, 3 or 7) has bits, from `first_reference + first`
//                       on
struct alignas(16) HierarchyNode {
  float origin[3];
  std::uint32_t exponents; // 8 bits per axis, biased as a float's; then a bit for each slot that holds a node
  std::uint32_t first_node, first_reference;
  std::uint32_t slots[2];  // 8 bits per slot
  std::uint32_t low[3][2]; // 8 bits per slot: the planes of the boxes, x, y, z
  std::uint32_t high[3][2];
};
static_assert(sizeof(HierarchyNode) == 80);

inline constexpr int boxes_per_node = 8;
inline constexpr unsigned max_references_per_box = 3, max_references_per_node = 24;
inline constexpr std::uint32_t node_slot = 0x38; // with the slot's number

// Nodes on the way from the root to a box, at most.
inline constexpr int max_hierarchy_depth = 48;

MASU_HD inline std::uint32_t node_slots(const HierarchyNode& node) {
  return node.exponents >> 24;
}
MASU_HD inline std::uint32_t slot_byte(const std::uint32_t (&words)[2], int slot) {
  return words[slot / 4] >> (slot % 4 * 8) & 0xff;
}
// Of a box of references, at which of the node's they begin and how many they are.
MASU_HD inline std::uint32_t references_begin(std::uint32_t slot) {
  return slot & 0x1f;
}
MASU_HD inline std::uint32_t references_in(std::uint32_t slot) {
  return (slot >> 5 & 1) + (slot >> 6 & 1) + (slot >> 7 & 1);
}

// Of a slot that holds something, relative to the scene's origin.
MASU_HD inline Boxd box_of(const HierarchyNode& node, int slot) {
  Boxd box{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto unit = static_cast<double>(float_of((node.exponents >> (8 * axis) & 0xff) << 23));
    const auto plane = [&](const std::uint32_t(&planes)[2]) {
      return std::fma(unit, slot_byte(planes, slot), static_cast<double>(node.origin[axis]));
    };
    box.min.set(axis, plane(node.low[axis]));
    box.max.set(axis, plane(node.high[axis]));
  }
  return box;
}

template <class Real>
struct HierarchyView {
  const HierarchyNode* nodes; // node 0 is the root
  const PrimitiveIndex* references;
};

// The same on a GPU: in the references' place their primitives, triangles nowhere else. A box's lie side by
// side, and nothing is read to find them.
template <class Real, class Stored>
struct LeafHierarchyView {
  const HierarchyNode* nodes;
  const Leaf<Stored>* leaves;
};

} // namespace masu
