// What a bounding volume hierarchy holds, in numbers.
#pragma once

#include "libgrid/trace/hierarchy_view.h"

#include <cstdint>
#include <span>

namespace masu {

struct HierarchyStatistics {
  std::uint64_t nodes = 0;
  std::uint64_t node_boxes = 0, reference_boxes = 0; // boxes of nodes, and of references
  std::uint64_t references = 0;
  int depth = 0;           // nodes from the root to the deepest, both counted
  double boxes_a_node = 0; // of 8, mean
  // Of a random ray that meets the root's box: nodes visited, and references tested, if nothing stopped it
  // (the surface area heuristic's expectation: Goldsmith & Salmon, "Automatic Creation of Object Hierarchies
  // for Ray Tracing", IEEE CG&A 7(5), 1987).
  double nodes_a_ray = 0, tests_a_ray = 0;
};

// Of checked nodes.
HierarchyStatistics hierarchy_statistics(std::span<const HierarchyNode> nodes);

} // namespace masu
