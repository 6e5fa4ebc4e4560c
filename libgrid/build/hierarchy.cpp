#include "libgrid/build/hierarchy.h"

#include "libgrid/build/binary_hierarchy.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace masu {
namespace {

// Of a visit to a node, relative to it: the test of a reference.
constexpr float test_cost = 0.3F;

// The least costs, in areas, of a binary node's contents in up to so many boxes of a wide node; and how many
// of them go to its left: 0 where fewer boxes cost no more.
struct Collapse {
  float cost[boxes_per_node]; // [i]: in up to i boxes, from 1 on
  std::uint8_t left[boxes_per_node + 1];
  bool is_leaf; // in one box: its references, not a node
};

class Collapser {
public:
  explicit Collapser(const BinaryHierarchy& binary)
      : fragments_(binary.fragments), nodes_(binary.nodes), best_(nodes_.size()) {}

  // Writes nodes and references.
  void collapse_to(Grid& hierarchy) {
    hierarchy.nodes.resize(1, {});
    if (nodes_.empty()) return;
    find_best(0);
    write(hierarchy, 0, 0);
  }

private:
  struct Boxes {
    std::array<std::uint32_t, boxes_per_node> nodes{};
    int count = 0;
    void add(std::uint32_t node) { nodes[static_cast<unsigned>(count++)] = node; }
  };

  void find_best(std::uint32_t number) {
    const BinaryNode& node = nodes_[number];
    Collapse& best = best_[number];
    const float area = node.box.area();
    const float as_leaf =
        node.count <= max_references_per_box ? area * static_cast<float>(node.count) * test_cost : INFINITY;
    best = {};
    if (node.left == 0) {
      std::fill_n(best.cost, boxes_per_node, as_leaf);
      best.is_leaf = true;
      return;
    }
    const auto find_left = [&] { find_best(node.left); };
    const auto find_right = [&] { find_best(node.left + 1); };
    if (node.count > 4096) {
      tbb::parallel_invoke(find_left, find_right);
    } else {
      find_left();
      find_right();
    }
    const Collapse &left = best_[node.left], &right = best_[node.left + 1];
    float distributed[boxes_per_node + 1];
    for (int boxes = 2; boxes <= boxes_per_node; ++boxes) {
      distributed[boxes] = INFINITY; // which the costs of vast boxes may add up to, too
      best.left[boxes] = 1;
      for (int to_left = 1; to_left < boxes; ++to_left) {
        const float cost = left.cost[to_left] + right.cost[boxes - to_left];
        if (cost < distributed[boxes]) {
          distributed[boxes] = cost;
          best.left[boxes] = static_cast<std::uint8_t>(to_left);
        }
      }
    }
    const float as_node = distributed[boxes_per_node] + area;
    best.is_leaf = as_leaf <= as_node;
    best.cost[1] = std::min(as_leaf, as_node);
    for (int boxes = 2; boxes < boxes_per_node; ++boxes) {
      const bool pays = distributed[boxes] < best.cost[boxes - 1];
      best.cost[boxes] = pays ? distributed[boxes] : best.cost[boxes - 1];
      if (!pays) best.left[boxes] = 0;
    }
  }

  // The boxes that a binary node takes up to so many of, as find_best() found them.
  void gather(std::uint32_t number, int boxes, Boxes& into) const {
    const auto place = [&](std::uint32_t child, int most) {
      while (most > 1 && best_[child].left[most] == 0)
        --most;
      most == 1 ? into.add(child) : gather(child, most, into);
    };
    const BinaryNode& node = nodes_[number];
    const int to_left = best_[number].left[boxes];
    place(node.left, to_left);
    place(node.left + 1, boxes - to_left);
  }

  void list(Grid& hierarchy, std::uint32_t number) const {
    const BinaryNode& node = nodes_[number];
    if (node.left == 0) return hierarchy.references.push_back(fragments_[node.first].primitive());
    list(hierarchy, node.left);
    list(hierarchy, node.left + 1);
  }

  // Units of the compressed boxes: powers of two, of which the node's box has 240 at most; it begins a few
  // after the origin.
  static constexpr double units = 240, units_before = 4;
  // Larger by this many units than what they hold: hierarchy_walk.h says why.
  static constexpr double slack = 1.0 / 64;

  void write(Grid& hierarchy, std::size_t place, std::uint32_t number) {
    Boxes boxes;
    // A root that is a leaf is a node of one box.
    const bool leaf = best_[number].is_leaf;
    leaf ? boxes.add(number) : gather(number, boxes_per_node, boxes);
    const LaneBox& around = nodes_[number].box;
    HierarchyNode node{};
    double unit[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = static_cast<double>(around.high[axis]) - static_cast<double>(around.low[axis]);
      // No smaller than the origin's rounding.
      const double least =
          std::max(extent / units, std::abs(static_cast<double>(around.low[axis])) * 0x1p-22);
      const int exponent = std::clamp(std::ilogb(std::max(least, 0x1p-100)) + 1, -100, 100);
      unit[axis] = std::ldexp(1.0, exponent);
      node.origin[axis] = rounded_down(static_cast<double>(around.low[axis]) - units_before * unit[axis]);
      node.exponents |= static_cast<std::uint32_t>(exponent + 127) << (8 * axis);
    }
    node.first_node = static_cast<std::uint32_t>(hierarchy.nodes.size());
    node.first_reference = static_cast<std::uint32_t>(hierarchy.references.size());
    Boxes inner;
    for (int slot = 0; slot < boxes.count; ++slot) {
      const int shift = slot % 4 * 8;
      const std::uint32_t child = boxes.nodes[static_cast<unsigned>(slot)];
      const BinaryNode& held = nodes_[child];
      for (int axis = 0; axis < 3; ++axis) {
        const double origin = node.origin[axis];
        const double low = std::floor((held.box.low[axis] - origin) / unit[axis] - slack),
                     high = std::ceil((held.box.high[axis] - origin) / unit[axis] + slack);
        node.low[axis][slot / 4] |= static_cast<std::uint32_t>(low) << shift;
        node.high[axis][slot / 4] |= static_cast<std::uint32_t>(high) << shift;
      }
      if (best_[child].is_leaf) {
        const auto first = static_cast<std::uint32_t>(hierarchy.references.size()) - node.first_reference;
        node.slots[slot / 4] |= (((1U << held.count) - 1) << 5 | first) << shift;
        list(hierarchy, child);
      } else {
        node.slots[slot / 4] |= (node_slot | static_cast<std::uint32_t>(slot)) << shift;
        node.exponents |= 1U << (24 + slot);
        inner.add(child);
      }
    }
    hierarchy.nodes.resize(hierarchy.nodes.size() + static_cast<unsigned>(inner.count));
    hierarchy.nodes[place] = node;
    for (int i = 0; i < inner.count; ++i)
      write(hierarchy, node.first_node + static_cast<unsigned>(i), inner.nodes[static_cast<unsigned>(i)]);
  }

  const HostArray<HierarchyFragment>& fragments_;
  const HostArray<BinaryNode>& nodes_;
  HostArray<Collapse> best_;
};

} // namespace

template <class Stored>
Grid hierarchy_grid(const SceneView<Stored>& scene, const GridLayout& layout,
                    const std::function<void(double)>& progress) {
  if (!fits_hierarchy(layout.space))
    throw Error(ErrorCode::usage, "structure",
                "a hierarchy holds coordinates up to 1e15: build a grid of voxels");
  check_hierarchy(scene.primitive_count(), available_memory());
  Grid grid;
  grid.layout = {layout.space, {1, 1, 1}, layout.margin};
  grid.kind = GridKind::hierarchy;
  const BinaryHierarchy binary = binary_hierarchy(scene, layout.margin, progress);
  Collapser(binary).collapse_to(grid);
  return grid;
}
template Grid hierarchy_grid(const SceneView<float>&, const GridLayout&, const std::function<void(double)>&);
template Grid hierarchy_grid(const SceneView<double>&, const GridLayout&, const std::function<void(double)>&);

} // namespace masu
