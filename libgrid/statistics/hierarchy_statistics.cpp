#include "libgrid/statistics/hierarchy_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace masu {
namespace {

// Half of a box's surface.
double area_of(const HierarchyNode& node, int slot) {
  std::array<double, 3> side{};
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = std::ldexp(1.0, static_cast<int>(node.exponents >> (8 * axis) & 0xff) - 127);
    side[static_cast<unsigned>(axis)] =
        unit * (static_cast<double>(slot_byte(node.high[axis], slot)) - slot_byte(node.low[axis], slot));
  }
  return side[0] * (side[1] + side[2]) + side[1] * side[2];
}

// Of the box around all of a node's.
double area_around(const HierarchyNode& node) {
  HierarchyNode around = node;
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t low = 255, high = 0;
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      if (slot_byte(node.slots, slot) == 0) continue;
      low = std::min(low, slot_byte(node.low[axis], slot));
      high = std::max(high, slot_byte(node.high[axis], slot));
    }
    around.low[axis][0] = std::min(low, high);
    around.high[axis][0] = high;
  }
  return area_of(around, 0);
}

} // namespace

void for_each_box(std::span<const HierarchyNode> nodes, const std::function<void(const HierarchyBox&)>& act) {
  std::vector<std::uint8_t> depths(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) { // a node's nodes come after it
    const HierarchyNode& node = nodes[i];
    auto next = static_cast<std::uint32_t>(node.first_node);
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t byte = slot_byte(node.slots, slot);
      if (byte == 0) continue;
      const bool is_node = (node_slots(node) >> slot & 1) != 0;
      if (is_node) depths[next] = static_cast<std::uint8_t>(depths[i] + 1);
      act({static_cast<std::uint32_t>(i), slot, depths[i], is_node ? 0 : references_in(byte),
           is_node ? next++ : 0});
    }
  }
}

HierarchyStatistics hierarchy_statistics(std::span<const HierarchyNode> nodes) {
  HierarchyStatistics found;
  found.nodes = nodes.size();
  double visited = 0, tested = 0;
  const double root = area_around(nodes[0]);
  for_each_box(nodes, [&](const HierarchyBox& box) {
    const double area = area_of(nodes[box.node], box.slot);
    found.depth = std::max(found.depth, box.depth + 1);
    if (box.references == 0) {
      ++found.node_boxes;
      visited += area;
      return;
    }
    ++found.reference_boxes;
    found.references += box.references;
    tested += area * box.references;
    const auto count = [](std::vector<std::uint64_t>& counts, std::size_t at) {
      if (counts.size() <= at) counts.resize(at + 1);
      ++counts[at];
    };
    count(found.boxes_by_references, box.references);
    count(found.boxes_by_depth, static_cast<std::size_t>(box.depth));
  });
  found.boxes_per_node =
      static_cast<double>(found.node_boxes + found.reference_boxes) / static_cast<double>(nodes.size());
  if (root > 0) {
    found.nodes_per_ray = 1 + visited / root;
    found.tests_per_ray = tested / root;
  }
  return found;
}

} // namespace masu
