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

// A binary node: its children, each another or an item from the number of items on, and the items below it.
struct RangeNode {
  std::uint32_t left, right, first, last;
};

// What threads of all passes read and write.
struct UpperArrays {
  const std::uint64_t* keys; // of items, in order
  const std::uint32_t* items;
  std::uint32_t count, groups; // of items; beyond these groups they aren't in any
  RangeNode* tree;
  Boxf* boxes; // of binary nodes, then of items
  std::uint32_t *arrivals, *roots;
  HierarchyNode* nodes;
  std::uint32_t* contents; // of each node: what it is of, or none
  std::uint32_t* widths;   // of each level, how many nodes

  static constexpr std::uint32_t none = ~0U;

  MASU_HD std::uint64_t group_of(std::uint32_t item) const { return keys[item] >> code_bits; }
  // How many of the highest bits the items before and after a border share; of equal keys numbers decide. -1
  // between groups, and at both ends.
  MASU_HD std::int32_t shared_bits(std::uint32_t after) const {
    if (after == 0 || after == count || group_of(after - 1) != group_of(after)) return -1;
    const std::uint64_t differing = keys[after - 1] ^ keys[after];
    return differing != 0 ? leading_zeros(differing)
                          : 64 + leading_zeros(std::uint64_t{after - 1} ^ std::uint64_t{after});
  }
  // Makes the binary nodes above an item: whoever comes to one second goes on. A group's root becomes the
  // node of its number.
  MASU_HD void add_item(std::uint32_t item, const Boxf& box) const {
    boxes[count + item] = box;
    std::uint32_t content = count + item, first = item, last = item;
    for (;;) {
      const std::int32_t before = shared_bits(first), after = shared_bits(last + 1);
      if (before < 0 && after < 0) break;
      const bool is_left =
          after > before; // never equal: of numbers in order none shares as many with both sides
      const std::uint32_t number = is_left ? last : first - 1;
      RangeNode& node = tree[number];
      (is_left ? node.left : node.right) = content;
      (is_left ? node.first : node.last) = is_left ? first : last;
      if (arrived(arrivals[number]) == 0) return;
      boxes[number] = join(boxes[node.left], boxes[node.right]);
      content = number;
      first = node.first;
      last = node.last;
    }
    const std::uint64_t group = group_of(first);
    if (group >= groups) return;
    contents[group] = content;
    roots[group] = static_cast<std::uint32_t>(group);
  }
  // Of a group without items nothing else is written.
  MASU_HD void add_group(std::uint32_t group) const {
    std::uint32_t low = 0, high = count; // before the first item of no group before
    while (low < high) {
      const std::uint32_t middle = low + (high - low) / 2;
      if (group_of(middle) < group)
        low = middle + 1;
      else
        high = middle;
    }
    if (low != count && group_of(low) == group) return;
    contents[group] = none;
    roots[group] = no_root;
  }

  // Node `i` of a level, and what is in the nodes below it; at the last level the nodes below, too.
  template <class Items>
  MASU_HD void write_level(const Items& made, int level, bool is_last, std::uint32_t i) const {
    if (i >= widths[level]) return;
    std::uint32_t begin = 0;
    for (int above = 0; above < level; ++above)
      begin += widths[above];
    const std::uint32_t begin_below = begin + widths[level];
    std::uint32_t pending[max_upper_levels * (boxes_per_node - 1) + 1];
    pending[0] = begin + i;
    for (int height = 1; height > 0;) {
      const std::uint32_t number = pending[--height];
      const std::uint32_t below = write_node(made, number, level, begin_below);
      for (std::uint32_t k = 0; is_last && k < below; ++k)
        pending[height++] = nodes[number].first_node + k;
    }
  }

private:
  // What is in a slot: a binary node, which may be divided, or an item.
  struct Held {
    std::uint32_t content, left, right;
    std::int32_t shared_bits;
  };
  static constexpr std::int32_t item_bits = 128; // more than there are
  MASU_HD Held hold(std::uint32_t content) const {
    if (content >= count) return {content, none, none, item_bits};
    return {content, tree[content].left, tree[content].right, shared_bits(content + 1)};
  }
  // Returns how many nodes are below it.
  template <class Items>
  MASU_HD std::uint32_t write_node(const Items& made, std::uint32_t number, int level,
                                   std::uint32_t begin_below) const {
    const std::uint32_t content = contents[number];
    if (content == none) return 0;
    if (content >= count) {
      nodes[number] = made.node(items[content - count]);
      return 0;
    }
    // What shares the fewest bits is divided first. Loops are as long as a node has slots: unrolled, all of
    // this is in registers.
    Held held[boxes_per_node] = {hold(content)};
    std::uint32_t holding = 1;
    while (holding < boxes_per_node) {
      Held divided = held[0];
      std::uint32_t from = 0;
      for (std::uint32_t slot = 1; slot < boxes_per_node; ++slot)
        if (slot < holding && held[slot].shared_bits < divided.shared_bits) {
          divided = held[slot];
          from = slot;
        }
      if (divided.shared_bits == item_bits) break;
      const Held left = hold(divided.left), right = hold(divided.right);
      for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot) {
        if (slot == from) held[slot] = left;
        if (slot == holding) held[slot] = right;
      }
      ++holding;
    }
    Boxf of_slots[boxes_per_node];
    for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot)
      of_slots[slot] = boxes[held[slot < holding ? slot : 0].content];
    HierarchyNode node{};
    const NodeUnits units(boxes[content], node);
    node.first_node = begin_below + added(widths[level + 1], holding);
    node.exponents |= ((1U << holding) - 1) << 24;
    for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot) {
      if (slot >= holding) continue;
      units.add_planes(static_cast<int>(slot), of_slots[slot], node);
      node.slots[slot / 4] |= (node_slot | slot) << slot % 4 * 8;
      contents[node.first_node + slot] = held[slot].content;
    }
    nodes[number] = node;
    return holding;
  }
};

// Above items in the order of their keys: of their group, and after that in `code_bits` of their place. Items
// of groups beyond `groups` aren't in any. `made.box(i)` and `made.node(i)`: of item i.
template <class Executor, class Items>
std::pair<ArrayOf<Executor, HierarchyNode>, ArrayOf<Executor, std::uint32_t>>
upper_hierarchies(Executor& executor, const Sorted<Executor, std::uint32_t>& sorted, std::uint32_t groups,
                  const Items& made) {
  const auto count = static_cast<std::uint32_t>(sorted.values.size());
  // Levels by all threads; what little is below them is left to those of the last one.
  const int levels = (static_cast<int>(std::bit_width(count)) + 2) / 3;
  // Of a binary node's eight boxes all are full, or all are items: so there are fewer than 4/7 nodes an item.
  auto nodes = executor.template array<HierarchyNode>(groups + count + std::uint64_t{count} * 4 / 7 + 1);
  auto roots = executor.template array<std::uint32_t>(groups);
  auto contents = executor.template array<std::uint32_t>(nodes.size());
  auto tree = executor.template array<RangeNode>(count);
  auto boxes = executor.template array<Boxf>(2 * std::uint64_t{count});
  auto arrivals = executor.template zeros<std::uint32_t>(count);
  auto widths = executor.template array<std::uint32_t>(static_cast<std::uint64_t>(levels) + 1);
  const UpperArrays upper{sorted.keys.data(), sorted.values.data(), count,           groups,
                          tree.data(),        boxes.data(),         arrivals.data(), roots.data(),
                          nodes.data(),       contents.data(),      widths.data()};
  executor.for_each(std::uint64_t{count} + groups, [=] MASU_PASS(std::uint64_t i) {
    const auto item = static_cast<std::uint32_t>(i);
    if (i < count)
      upper.add_item(item, made.box(upper.items[item]));
    else
      upper.add_group(static_cast<std::uint32_t>(i - count));
    for (std::uint64_t level = 0; i == count && level <= static_cast<std::uint64_t>(levels); ++level)
      upper.widths[level] = level == 0 ? groups : 0;
  });
  std::uint64_t most = groups; // nodes of a level: each has items of its own
  for (int level = 0; level < levels; ++level, most = std::min(8 * most, std::uint64_t{count}))
    executor.for_each(most, [=] MASU_PASS(std::uint64_t i) {
      upper.write_level(made, level, level + 1 == levels, static_cast<std::uint32_t>(i));
    });
  return {std::move(nodes), std::move(roots)};
}

} // namespace masu
