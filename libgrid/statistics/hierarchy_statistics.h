// What a bounding volume hierarchy holds, in numbers.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace masu {

struct HierarchyStatistics {
  std::uint64_t nodes = 0;
  std::uint64_t node_boxes = 0, reference_boxes = 0; // boxes of nodes, and of references
  std::uint64_t references = 0;
  int depth = 0;             // nodes from the root to the deepest, both counted
  double boxes_per_node = 0; // of 8, mean
  // Of a random ray that meets the root's box: nodes visited, and references tested, if nothing stopped it
  // (the surface area heuristic's expectation: Goldsmith & Salmon, "Automatic Creation of Object Hierarchies
  // for Ray Tracing", IEEE CG&A 7(5), 1987).
  double nodes_per_ray = 0, tests_per_ray = 0;
  std::vector<std::uint64_t> boxes_by_references{}, boxes_by_depth{}; // boxes of references
};

// A box of a node: around another node, or around references.
struct HierarchyBox {
  std::uint32_t node;
  int slot, depth;          // of the node; the root's is 0
  std::uint32_t references; // 0 for a box around a node
  std::uint32_t inner;      // that node; 0, the root, for a box of references
};
// In the order of the nodes, and in a node of the slots. Of checked nodes.
void for_each_box(std::span<const HierarchyNode> nodes, const std::function<void(const HierarchyBox&)>& act);

// Of checked nodes.
HierarchyStatistics hierarchy_statistics(std::span<const HierarchyNode> nodes);

} // namespace masu
