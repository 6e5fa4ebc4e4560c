// Hierarchies above placed items, one of each group, on whatever executor (executor.h): from the items sorted
// along a Morton curve, group by group.
//
//   1. tree   binary, with boxes, from the items up: what joins with its neighbours on the side where keys
//             share more bits is a node's, of the number of the last item to its left (Apetrei, "Fast and
//             Simple Agglomerative LBVH Construction", CGVC 2014); and roots of groups
//   2. nodes  of eight boxes, level by level: of a binary node what is left when the largest cells of the
//             curve below it have been divided. An item is a node, too, without boxes.
//
// The order of nodes depends on the executor; what is in them doesn't.
#pragma once

#include "libgrid/hierarchy/node_boxes.h"
#include "libgrid/placed/placed_view.h"
#include "libscene/passes/passes.h"

#include <bit>
#include <utility>

namespace masu {

// Of a key, for the place along the curve: 1024 along each axis. Fewer bits are sorted in fewer passes.
inline constexpr int code_bits = 30;

// A node has divided all that shares fewer than three bits more than itself, which are no more than seven.
inline constexpr int max_upper_levels = (code_bits + 32 + 2) / 3;

// What is on one side of a binary node: an item, from the number of items on, or another binary node.
struct alignas(16) TreeSide {
  Boxf box;
  std::uint32_t content;
  std::int32_t own_bits;    // that all of its items share; of a single one item_bits
  std::uint32_t end;        // its first item on the left side, its last on the right
  std::int32_t beyond_bits; // shared by that item and the one before or after it
};
struct RangeNode {
  TreeSide sides[2];
};

// What threads of all passes read and write.
struct UpperArrays {
  const std::uint64_t* keys; // of items, in order
  const std::uint32_t* items;
  std::uint32_t count, groups; // of items; beyond these groups they aren't in any
  RangeNode* tree;
  std::uint32_t *arrivals, *roots;
  HierarchyNode* nodes;
  TreeSide* contents;    // of each node: what it is of
  std::uint32_t* widths; // of each level, how many nodes

  static constexpr std::uint32_t none = ~0U;
  static constexpr std::int32_t item_bits = 128; // more than any two share

  MASU_HD std::uint64_t group_of(std::uint32_t item) const { return keys[item] >> code_bits; }
  // How many of the highest bits the items before and after a border share; of equal keys numbers decide. -1
  // between groups, and at both ends.
  MASU_HD std::int32_t shared_bits(std::uint32_t after) const {
    if (after == 0 || after == count || group_of(after - 1) != group_of(after)) return -1;
    const std::uint64_t differing = keys[after - 1] ^ keys[after];
    return differing != 0 ? leading_zeros(differing)
                          : 64 + leading_zeros(std::uint64_t{after - 1} ^ std::uint64_t{after});
  }
  // Makes the binary nodes above an item: whoever comes to one second goes on, and reads all that it needs of
  // the other side at once. A group's root becomes the node of its number.
  MASU_HD void add_item(std::uint32_t item, const Boxf& box) const {
    TreeSide own{box, count + item, item_bits, item, 0};
    std::uint32_t first = item, last = item;
    std::int32_t before = shared_bits(first), after = shared_bits(last + 1);
    while (before >= 0 || after >= 0) {
      const bool is_left =
          after > before; // never equal: of numbers in order none shares as many with both sides
      const std::uint32_t number = is_left ? last : first - 1;
      own.end = is_left ? first : last;
      own.beyond_bits = is_left ? before : after;
      TreeSide* const sides = tree[number].sides;
      sides[is_left ? 0 : 1] = own;
      if (arrived(arrivals[number]) == 0) return;
      const TreeSide other = sides[is_left ? 1 : 0];
      own.box = join(own.box, other.box);
      own.content = number;
      own.own_bits = is_left ? after : before;
      (is_left ? last : first) = other.end;
      (is_left ? after : before) = other.beyond_bits;
    }
    const std::uint64_t group = group_of(first);
    if (group >= groups) return;
    contents[group] = own;
    roots[group] = static_cast<std::uint32_t>(group);
  }
  // Of a group without items nothing else is written.
  MASU_HD void add_group(std::uint32_t group) const {
    const auto of = [this](std::uint32_t item) { return group_of(item); };
    if (count > 0 && of(0) <= group && of(last_not_above(count, group, of)) == group) return;
    contents[group].content = none;
    roots[group] = no_root;
  }
};

// A level of nodes, by a few threads each.
template <class Items>
struct WriteLevel {
  // What is in a node's slots, and the first node below it.
  struct Scratch {
    TreeSide slots[boxes_per_node];
    std::uint32_t first_node;
  };
  UpperArrays upper;
  Items made;
  int level;
  bool is_last;

  // Node `i` of the level, and what is in the nodes below it; at the last level the nodes below, too.
  template <class Group>
  MASU_HD void operator()(const Group& group, Scratch& scratch, std::uint64_t i) const {
    if (i >= upper.widths[level]) return;
    std::uint32_t begin = 0;
    for (int above = 0; above < level; ++above)
      begin += upper.widths[above];
    const std::uint32_t begin_below = begin + upper.widths[level];
    std::uint32_t pending[max_upper_levels * (boxes_per_node - 1) + 1];
    pending[0] = begin + static_cast<std::uint32_t>(i);
    for (int height = 1; height > 0;) {
      const std::uint32_t below = write_node(group, scratch, pending[--height], begin_below);
      for (std::uint32_t k = 0; is_last && k < below; ++k)
        pending[height++] = scratch.first_node + k;
    }
  }

private:
  // Returns how many nodes are below it.
  template <class Group>
  MASU_HD std::uint32_t write_node(const Group& group, Scratch& scratch, std::uint32_t number,
                                   std::uint32_t begin_below) const {
    const std::uint32_t rank = group.thread_rank();
    const TreeSide content = upper.contents[number];
    if (content.content == UpperArrays::none) return 0;
    if (content.content >= upper.count) {
      if (rank == 0) upper.nodes[number] = made.node(upper.items[content.content - upper.count]);
      return 0;
    }
    group.sync(); // the last node's slots have been read
    if (rank == 0) scratch.slots[0] = content;
    const std::uint32_t used = divided(group, scratch, content.own_bits);
    if (rank == 0) scratch.first_node = begin_below + added(upper.widths[level + 1], used);
    group.sync();
    HierarchyNode node{};
    const NodeUnits units(content.box, node);
    node.first_node = scratch.first_node;
    node.exponents |= ((1U << used) - 1) << 24;
    for (std::uint32_t slot = rank; slot < used; slot += group.size()) {
      units.add_planes(static_cast<int>(slot), scratch.slots[slot].box, node);
      node.slots[slot / 4] |= (node_slot | slot) << slot % 4 * 8;
      upper.contents[node.first_node + slot] = scratch.slots[slot];
    }
    for (int part = 0; part < 2; ++part) {
      node.slots[part] = group.all_bits(node.slots[part]);
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][part] = group.all_bits(node.low[axis][part]);
        node.high[axis][part] = group.all_bits(node.high[axis][part]);
      }
    }
    if (rank == 0) upper.nodes[number] = node;
    group.sync(); // contents are there
    return used;
  }
  // Divides what is in slots, first what shares the fewest bits: all at once that shares fewer than three
  // bits more than the node, which are no more than seven, then all that shares as few as any, while there
  // are slots. Returns how many are used.
  template <class Group>
  MASU_HD std::uint32_t divided(const Group& group, Scratch& scratch, std::int32_t bits_of_node) const {
    for (std::uint32_t used = 1;;) {
      group.sync();
      std::int32_t least = UpperArrays::item_bits;
      for (std::uint32_t slot = 0; slot < used; ++slot)
        least = min(least, scratch.slots[slot].own_bits);
      const std::int32_t most = min(max(least, bits_of_node + 2), UpperArrays::item_bits - 1);
      std::uint32_t divides = 0, free = boxes_per_node - used;
      for (std::uint32_t slot = 0; slot < used && free > 0; ++slot)
        if (scratch.slots[slot].own_bits <= most) {
          divides |= 1U << slot;
          --free;
        }
      if (divides == 0) return used;
      group.sync();
      for (std::uint32_t slot = group.thread_rank(); slot < used; slot += group.size()) {
        if ((divides >> slot & 1) == 0) continue;
        const RangeNode of = upper.tree[scratch.slots[slot].content];
        scratch.slots[slot] = of.sides[0];
        scratch.slots[used + count_bits(divides & ~(~0U << slot))] = of.sides[1];
      }
      used = boxes_per_node - free;
    }
  }
};

// Above items in the order of their keys: of their group, and after that in `code_bits` of their place. Items
// of groups beyond `groups` aren't in any. `arrivals`: 0 of each item. `made.box(i)` and `made.node(i)`: of
// item i.
template <class Executor, class Items>
std::pair<ArrayOf<Executor, HierarchyNode>, ArrayOf<Executor, std::uint32_t>>
upper_hierarchies(const Executor& executor, const Sorted<Executor, std::uint32_t>& sorted,
                  std::uint32_t* arrivals, std::uint32_t groups, const Items& made) {
  const auto count = static_cast<std::uint32_t>(sorted.values.size());
  // Levels by all threads; what little is below them is left to those of the last one.
  const int levels = (static_cast<int>(std::bit_width(count)) + 2) / 3;
  // Of a binary node's eight boxes all are full, or all are items: so there are fewer than 4/7 nodes an item.
  auto nodes = executor.template array<HierarchyNode>(groups + count + std::uint64_t{count} * 4 / 7 + 1);
  auto roots = executor.template array<std::uint32_t>(groups);
  auto contents = executor.template array<TreeSide>(nodes.size());
  auto tree = executor.template array<RangeNode>(count);
  auto widths = executor.template zeros<std::uint32_t>(static_cast<std::uint64_t>(levels) + 1);
  const UpperArrays upper{
      sorted.keys.data(), sorted.values.data(), count,        groups,          tree.data(),
      arrivals,           roots.data(),         nodes.data(), contents.data(), widths.data()};
  executor.for_each(std::uint64_t{count} + groups, [=] MASU_PASS(std::uint64_t i) {
    const auto item = static_cast<std::uint32_t>(i);
    if (i < count)
      upper.add_item(item, made.box(upper.items[item]));
    else
      upper.add_group(static_cast<std::uint32_t>(i - count));
    if (i == count) upper.widths[0] = groups;
  });
  std::uint64_t most = groups; // nodes of a level: each has items of its own
  for (int level = 0; level < levels; ++level, most = std::min(8 * most, std::uint64_t{count}))
    executor.for_each_by_group(most, WriteLevel<Items>{upper, made, level, level + 1 == levels});
  return {std::move(nodes), std::move(roots)};
}

} // namespace masu
