// From a binary hierarchy to one of eight boxes per node, on whatever executor (executor.h): to the cheapest
// nodes that it can be collapsed to, by dynamic programming (Ylitie, Karras & Laine, HPG 2017):
//
//   1. costs   of each binary node, by whoever makes it, from its children's (collapse_costs())
//   2. levels  of nodes, from the root down: which binary nodes their boxes are of
//   3. sizes   how many nodes are in a node's subtree, from the lowest level up
//   4. write   nodes and references, from the root down: depth first, a node's nodes side by side
//
// No byte of the result depends on the executor, its number of threads, or the numbers of binary nodes.
#pragma once

#include "libgrid/hierarchy/node_boxes.h"
#include "libgrid/structure/structure.h"
#include "libgrid/structure/unit_costs.h"
#include "libscene/base/atomic.h"
#include "libscene/base/fetch.h"
#include "libscene/passes/passes.h"

#include <utility>
#include <vector>

namespace masu {

struct alignas(16) BinaryNode {
  Vec3f min;
  std::uint32_t index; // a leaf's primitive; else the left child's number, which the right one's follows
  Vec3f max;
  std::uint32_t count; // of references in it; 1: a leaf

  MASU_HD Boxf box() const { return {min, max}; }
};
static_assert(sizeof(BinaryNode) == 32);

// A node of two others, `left` and the one after it. Two parts of a primitive whose box isn't larger than
// both of theirs are one part: it is tested once.
MASU_HD inline BinaryNode node_of(const Boxf& box, std::uint32_t left, const BinaryNode& a,
                                  const BinaryNode& b) {
  if (a.count == 1 && b.count == 1 && a.index == b.index &&
      half_area(box) <= half_area(a.box()) + half_area(b.box()))
    return {box.min, a.index, box.max, 1};
  return {box.min, left, box.max, a.count + b.count};
}

// How a binary node is collapsed where its contents may take up to 2 … 8 boxes of a node: how many of them go
// to its left, 0 where fewer boxes cost no more, 3 bits each; and whether in one box they are references.
struct CollapseChoice {
  std::uint32_t bits;

  MASU_HD std::uint32_t to_left(std::uint32_t boxes) const { return bits >> 3 * (boxes - 2) & 7; }
  MASU_HD bool is_leaf() const { return bits >> 31 != 0; }
};

struct alignas(16) CollapseCosts {
  CollapseChoice choice;
  float cost[boxes_per_node - 1]; // [i]: the least in up to i + 1 boxes, in areas

  MASU_HD float in(std::uint32_t boxes) const { return cost[boxes - 1]; }
};
static_assert(sizeof(CollapseCosts) == 32);

inline constexpr auto test_cost = static_cast<float>(collapse_unit_costs.test);
static_assert(collapse_unit_costs.step == 1);

MASU_HD inline CollapseCosts collapse_costs_of_leaf(const BinaryNode& node) {
  CollapseCosts costs{{1U << 31}, {}};
  for (float& cost : costs.cost)
    cost = half_area(node.box()) * test_cost;
  return costs;
}

MASU_HD inline CollapseCosts collapse_costs(const BinaryNode& node, const CollapseCosts& left,
                                            const CollapseCosts& right) {
  if (node.count == 1) return collapse_costs_of_leaf(node);
  const float area = half_area(node.box()), as_leaf = node.count <= max_references_per_box
                                                          ? area * static_cast<float>(node.count) * test_cost
                                                          : INFINITY;
  std::uint32_t bits = 0;
  float distributed[boxes_per_node + 1];
  for (std::uint32_t boxes = 2; boxes <= boxes_per_node; ++boxes) {
    distributed[boxes] = INFINITY; // which the costs of vast boxes may add up to, too
    std::uint32_t most_left = 1;
    for (std::uint32_t to_left = 1; to_left < boxes; ++to_left) {
      const float cost = left.in(to_left) + right.in(boxes - to_left);
      if (!(cost < distributed[boxes])) continue;
      distributed[boxes] = cost;
      most_left = to_left;
    }
    bits |= most_left << 3 * (boxes - 2);
  }
  const float as_node = distributed[boxes_per_node] + area;
  CollapseCosts costs{};
  costs.cost[0] = std::min(as_leaf, as_node);
  if (as_leaf <= as_node) bits |= 1U << 31;
  for (std::uint32_t boxes = 2; boxes < boxes_per_node; ++boxes) {
    const bool pays = distributed[boxes] < costs.in(boxes - 1);
    costs.cost[boxes - 1] = pays ? distributed[boxes] : costs.in(boxes - 1);
    if (!pays) bits &= ~(7U << 3 * (boxes - 2));
  }
  costs.choice = {bits};
  return costs;
}

// In an executor's memory. Node 0 is the root; there are none for no primitives.
template <class Executor>
struct BinaryHierarchy {
  ArrayOf<Executor, BinaryNode> nodes{};
  ArrayOf<Executor, CollapseChoice> choices{};
};

struct BinaryView {
  const BinaryNode* nodes;
  const CollapseChoice* choices;

  // What is soon looked at of a pair.
  MASU_ALWAYS_INLINE void prefetch_pair(std::uint32_t left) const {
    prefetch(reinterpret_cast<const BinaryNode(*)[2]>(nodes + left));
    prefetch(choices + left);
  }
};

// The binary nodes that a node's boxes are of, and which of them are nodes again.
struct CollapsedNode {
  std::uint32_t boxes[boxes_per_node];
  std::uint32_t count, nodes; // nodes: a bit each
};

MASU_HD inline CollapsedNode collapsed(const BinaryView& binary, std::uint32_t root) {
  CollapsedNode node{};
  const auto add = [&](std::uint32_t number, bool is_leaf) {
    if (!is_leaf) node.nodes |= 1U << node.count;
    node.boxes[node.count++] = number;
  };
  if (binary.choices[root].is_leaf()) { // a root: a node of one box
    add(root, true);
    return node;
  }
  struct Part {
    std::uint32_t number, boxes;
  } stack[boxes_per_node] = {{root, boxes_per_node}};
  for (int height = 1; height > 0;) {
    Part part = stack[--height];
    const CollapseChoice choice = binary.choices[part.number];
    while (part.boxes > 1 && choice.to_left(part.boxes) == 0)
      --part.boxes;
    if (part.boxes == 1) {
      add(part.number, choice.is_leaf());
      continue;
    }
    const std::uint32_t left = binary.nodes[part.number].index, to_left = choice.to_left(part.boxes);
    binary.prefetch_pair(left);
    stack[height++] = {left + 1, part.boxes - to_left};
    stack[height++] = {left, to_left};
  }
  return node;
}

// Where a node is written, and its nodes and references.
struct NodePlace {
  std::uint32_t node, first_node, first_reference;
};

// Writes a binary leaf or its few references, and returns how many they are.
MASU_HD inline std::uint32_t write_references(const BinaryView& binary, std::uint32_t number,
                                              PrimitiveIndex* references) {
  std::uint32_t stack[max_references_per_box] = {number}, count = 0;
  for (int height = 1; height > 0;) {
    const BinaryNode& node = binary.nodes[stack[--height]];
    if (node.count == 1) {
      references[count++] = node.index;
    } else {
      stack[height++] = node.index + 1;
      stack[height++] = node.index;
    }
  }
  return count;
}

// A node, and the references in its boxes; returns how many they are.
MASU_HD inline std::uint32_t write_node(const BinaryView& binary, std::uint32_t root,
                                        const CollapsedNode& from, const NodePlace& place,
                                        HierarchyNode* nodes, PrimitiveIndex* references) {
  HierarchyNode node{};
  node.first_node = place.first_node;
  node.first_reference = place.first_reference;
  const NodeUnits units(binary.nodes[root].box(), node);
  std::uint32_t listed = 0;
  for (std::uint32_t slot = 0; slot < from.count; ++slot) {
    const BinaryNode& held = binary.nodes[from.boxes[slot]];
    units.add_planes(static_cast<int>(slot), held.box(), node);
    std::uint32_t content = node_slot | slot;
    if ((from.nodes >> slot & 1) != 0) {
      node.exponents |= 1U << (24 + slot);
    } else {
      content = ((1U << held.count) - 1) << 5 | listed;
      listed += write_references(binary, from.boxes[slot], references + place.first_reference + listed);
    }
    node.slots[slot / 4] |= content << slot % 4 * 8;
  }
  nodes[place.node] = node;
  return listed;
}

// How many records a level has, as passes know it, of which there may be room for more.
struct LevelCount {
  std::uint64_t room;
  const std::uint32_t* count; // null: as many

  MASU_HD std::uint64_t operator()() const { return count != nullptr ? *count : room; }
};

// Nodes of one depth, in any order; those below one follow each other in the next level. Where there is room
// for more nodes than there are, those have no boxes.
template <class Executor>
struct CollapsedLevel {
  LevelCount count{};
  ArrayOf<Executor, std::uint32_t> roots{}; // binary nodes
  ArrayOf<Executor, CollapsedNode> nodes{};
  ArrayOf<Executor, std::uint32_t> first_child{}; // in the next level
  ArrayOf<Executor, std::uint32_t> sizes{};       // nodes in the subtree
};

// So many nodes before one is collapsed or written, what it is made from is prefetched: the binary nodes of a
// level lie far apart.
inline constexpr std::uint64_t nodes_ahead = 4;

// Collapses the nodes of a level; returns the next one. `counts`: of each depth, but for the root's, how many
// nodes there are; 0 of the next one. Where its nodes may well be as many as there is room for, in a
// hierarchy of so many leaves, the host doesn't wait to be told.
template <class Executor>
CollapsedLevel<Executor> collapse_level(Executor& executor, const BinaryView& binary, std::uint64_t leaves,
                                        ArrayOf<Executor, std::uint32_t>& counts, std::size_t depth,
                                        CollapsedLevel<Executor>& level) {
  const std::uint64_t room = level.count.room, most = boxes_per_node * room;
  level.nodes = executor.template array<CollapsedNode>(room);
  level.first_child = executor.template array<std::uint32_t>(room);
  std::uint32_t* const below_count = counts.data() + depth + 1;
  CollapsedLevel<Executor> below{{most, below_count}, executor.template array<std::uint32_t>(most)};
  CollapsedNode* const node = level.nodes.data();
  std::uint32_t *const first_child = level.first_child.data(), *const root_below = below.roots.data();
  const std::uint32_t* const root = level.roots.data();
  executor.for_each_part(room, [=, count = level.count] MASU_PASS(std::uint64_t begin, std::uint64_t end) {
    const std::uint64_t there = count();
    std::uint32_t children = 0;
    for (std::uint64_t i = begin; i != end; ++i) {
      if (i + 2 * nodes_ahead < there) binary.prefetch_pair(root[i + 2 * nodes_ahead]);
      if (i + nodes_ahead < there) binary.prefetch_pair(binary.nodes[root[i + nodes_ahead]].index);
      node[i] = i < there ? collapsed(binary, root[i]) : CollapsedNode{};
      children += count_bits(node[i].nodes);
    }
    std::uint32_t child = added_few(*below_count, children);
    for (std::uint64_t i = begin; i != end; ++i) {
      first_child[i] = child;
      for (std::uint32_t slot = 0; slot < node[i].count; ++slot)
        if ((node[i].nodes >> slot & 1) != 0) root_below[child++] = node[i].boxes[slot];
    }
  });
  if (boxes_per_node * most > leaves) below.count.room = executor.value(counts, depth + 1);
  return below;
}

template <class Executor>
void count_subtrees(Executor& executor, CollapsedLevel<Executor>& level,
                    const CollapsedLevel<Executor>& below) {
  level.sizes = executor.template array<std::uint32_t>(level.count.room);
  executor.for_each(level.count.room, [size = level.sizes.data(), node = level.nodes.data(),
                                       first_child = level.first_child.data(),
                                       child_size = below.sizes.data()] MASU_PASS(std::uint64_t i) {
    std::uint32_t sum = 1;
    for (std::uint32_t k = 0; k != count_bits(node[i].nodes); ++k)
      sum += child_size[first_child[i] + k];
    size[i] = sum;
  });
}

// Returns the places of the nodes below.
template <class Executor>
ArrayOf<Executor, NodePlace>
write_level(Executor& executor, const BinaryView& binary, const CollapsedLevel<Executor>& level,
            const CollapsedLevel<Executor>& below, const ArrayOf<Executor, NodePlace>& places,
            ExecutorStructure<Executor>& structure) {
  auto child_places = executor.template array<NodePlace>(below.count.room);
  executor.for_each(level.count.room, [=, count = level.count.room, root = level.roots.data(),
                                       node = level.nodes.data(), first_child = level.first_child.data(),
                                       child_size = below.sizes.data(), child_root = below.roots.data(),
                                       place = places.data(), child_place = child_places.data(),
                                       nodes = structure.nodes.data(),
                                       references = structure.references.data()] MASU_PASS(std::uint64_t i) {
    if (node[i].count == 0) return;
    if (const std::uint64_t next = i + nodes_ahead; next < count)
      for (std::uint32_t slot = 0; slot < node[next].count; ++slot)
        prefetch(binary.nodes + node[next].boxes[slot]);
    const std::uint32_t first = first_child[i], end = first + count_bits(node[i].nodes);
    NodePlace next{place[i].first_node, place[i].first_node + end - first, place[i].first_reference};
    next.first_reference += write_node(binary, root[i], node[i], place[i], nodes, references);
    for (std::uint32_t child = first; child != end; ++child) {
      child_place[child] = next;
      ++next.node;
      next.first_node += child_size[child] - 1;
      next.first_reference += binary.nodes[child_root[child]].count;
    }
  });
  return child_places;
}

// As a grid of the layout's space, in one voxel. What isn't read any more is freed meanwhile: this is where a
// build takes most memory.
template <class Executor>
ExecutorStructure<Executor> collapsed_hierarchy(Executor& executor, const GridLayout& layout,
                                                BinaryHierarchy<Executor> from) {
  ExecutorStructure<Executor> structure{{layout.space, {1, 1, 1}, layout.margin}, StructureKind::hierarchy};
  if (from.nodes.size() == 0) {
    structure.nodes = executor.template zeros<HierarchyNode>(1);
    return structure;
  }
  const BinaryView binary{from.nodes.data(), from.choices.data()};
  auto counts = executor.template zeros<std::uint32_t>(max_hierarchy_depth + 2);
  CollapsedLevel<Executor> next{{1, nullptr}, executor.template zeros<std::uint32_t>(1)};
  std::vector<CollapsedLevel<Executor>> levels; // the last one is empty
  std::size_t depth = 0;
  for (; next.count.room > 0; ++depth) {
    levels.push_back(std::move(next));
    next = collapse_level(executor, binary, from.nodes.size() / 2, counts, depth, levels.back());
  }
  levels.emplace_back();
  from.choices = {};
  for (std::size_t level = depth; level-- > 0;)
    count_subtrees(executor, levels[level], levels[level + 1]);
  auto places = executor.template array<NodePlace>(2); // the root's, and what would come after all
  executor.for_each(1, [=, place = places.data(), size = levels[0].sizes.data()] MASU_PASS(std::uint64_t) {
    place[0] = {0, 1, 0};
    place[1] = {*size, *size, binary.nodes[0].count};
  });
  const NodePlace end = executor.value(places, 1);
  structure.nodes = executor.template array<HierarchyNode>(end.node);
  structure.references = executor.template array<PrimitiveIndex>(end.first_reference);
  for (std::size_t level = 0; level < depth; ++level) {
    places = write_level(executor, binary, levels[level], levels[level + 1], places, structure);
    levels[level] = {};
  }
  return structure;
}

} // namespace masu
