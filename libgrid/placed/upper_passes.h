// Hierarchies above placed items, one of each group, on whatever executor (executor.h): from the items sorted
// along a Morton curve, group by group.
//
//   1. tree   binary: each node divides a range of items where the highest bit changes in which their keys
//             differ, all nodes at once (Karras, "Maximizing Parallelism in the Construction of BVHs,
//             Octrees, and k-d Trees", HPG 2012)
//   2. boxes  from the items up: a node's by whoever comes to it second; and roots of groups
//   3. nodes  of eight boxes, level by level: of a binary node what is left when the largest cells of the
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

// Of a binary node: its items, the last of those to the left, and how many of the keys' highest bits they
// share. A child of one item is the item; else the left one has the number `split`, the right one the next.
struct RangeNode {
  std::uint32_t first, last, split;
  std::int32_t shared_bits;
};

struct RangeTree {
  const std::uint64_t* keys;
  std::uint32_t count; // of items; one less of nodes

  // Of equal keys numbers decide.
  MASU_HD std::int32_t shared_bits(std::int64_t i, std::int64_t k) const {
    if (k < 0 || k >= count) return -1;
    const std::uint64_t differing = keys[i] ^ keys[k];
    return differing != 0 ? leading_zeros(differing) : 64 + leading_zeros(static_cast<std::uint64_t>(i ^ k));
  }
  MASU_HD RangeNode node(std::int64_t i) const {
    // The other end lies towards the neighbour that shares more.
    const std::int64_t towards = shared_bits(i, i + 1) > shared_bits(i, i - 1) ? 1 : -1;
    const std::int32_t outside = shared_bits(i, i - towards);
    std::int64_t far = 2, length = 0;
    while (shared_bits(i, i + far * towards) > outside)
      far *= 2;
    for (std::int64_t step = far / 2; step > 0; step /= 2)
      if (shared_bits(i, i + (length + step) * towards) > outside) length += step;
    const std::int64_t end = i + length * towards;
    const std::int32_t shared = shared_bits(i, end);
    std::int64_t split = 0;
    for (std::int64_t divisor = 2, step = length; step > 1; divisor *= 2) {
      step = (length + divisor - 1) / divisor;
      if (split + step < length && shared_bits(i, i + (split + step) * towards) > shared) split += step;
    }
    const std::int64_t first = towards > 0 ? i : end, last = towards > 0 ? end : i;
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last),
            static_cast<std::uint32_t>(towards > 0 ? i + split : i - split - 1), shared};
  }
};

// Of a key, for the place along the curve: 1024 along each axis. Fewer bits are sorted in fewer passes.
inline constexpr int code_bits = 30;

// A node has divided all that shares fewer than three bits more than itself, which are no more than seven.
inline constexpr int max_upper_levels = (code_bits + 32 + 2) / 3;

// What threads of all passes read and write. A child of a binary node is another, or an item from `count` on.
struct UpperArrays {
  RangeTree order;
  const std::uint32_t* items;
  RangeNode* tree;
  Boxf* boxes;            // of binary nodes, then of items
  std::uint32_t* parents; // likewise
  std::uint32_t* arrivals;
  HierarchyNode* nodes;
  std::uint32_t* contents; // of each node: what it is of, or none
  std::uint32_t* widths;   // of each level, how many nodes

  static constexpr std::uint32_t none = ~0U;

  MASU_HD std::uint32_t left(const RangeNode& node) const {
    return node.first == node.split ? order.count + node.first : node.split;
  }
  MASU_HD std::uint32_t right(const RangeNode& node) const {
    return node.last == node.split + 1 ? order.count + node.last : node.split + 1;
  }
  MASU_HD void add_tree_node(std::uint32_t i) const {
    tree[i] = order.node(i);
    arrivals[i] = 0;
    parents[left(tree[i])] = parents[right(tree[i])] = i;
    if (tree[i].first == 0 && tree[i].last == order.count - 1) parents[i] = none;
  }
  MASU_HD void join_boxes(std::uint32_t item, const Boxf& box) const {
    boxes[order.count + item] = box;
    if (order.count == 1) return;
    for (std::uint32_t i = parents[order.count + item]; i != none && arrived(arrivals[i]) != 0;
         i = parents[i])
      boxes[i] = join(boxes[left(tree[i])], boxes[right(tree[i])]);
  }
  // Makes a group's root the node of its number. Returns that, or none.
  MASU_HD std::uint32_t add_root(std::uint32_t group) const {
    const std::uint32_t first = first_of(group), end = first_of(group + 1);
    contents[group] = first != end ? content_of(first, end) : none;
    return first != end ? group : no_root;
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
      const std::uint32_t count = write_node(made, number, level, begin_below);
      for (std::uint32_t k = 0; is_last && k < count; ++k)
        pending[height++] = nodes[number].first_node + k;
    }
  }

private:
  // The first item of no group before.
  MASU_HD std::uint32_t first_of(std::uint64_t group) const {
    std::uint32_t low = 0, high = order.count;
    while (low < high) {
      const std::uint32_t middle = low + (high - low) / 2;
      if (order.keys[middle] >> code_bits < group)
        low = middle + 1;
      else
        high = middle;
    }
    return low;
  }
  // What the hierarchy of a range of items is of.
  MASU_HD std::uint32_t content_of(std::uint32_t first, std::uint32_t end) const {
    if (end - first == 1) return order.count + first;
    return tree[first].first == first && tree[first].last == end - 1 ? first : end - 1;
  }
  static constexpr std::int32_t item_bits = 128; // more than there are
  MASU_HD RangeNode range_of(std::uint32_t content) const {
    return content < order.count ? tree[content] : RangeNode{0, 0, 0, item_bits};
  }
  // Returns how many nodes are below it.
  template <class Items>
  MASU_HD std::uint32_t write_node(const Items& made, std::uint32_t number, int level,
                                   std::uint32_t begin_below) const {
    const std::uint32_t content = contents[number];
    if (content == none) return 0;
    if (content >= order.count) {
      nodes[number] = made.node(items[content - order.count]);
      return 0;
    }
    // What shares the fewest bits is divided first. Loops are as long as a node has slots: unrolled, all of
    // this is in registers.
    std::uint32_t held[boxes_per_node] = {content}, count = 1;
    RangeNode ranges[boxes_per_node] = {range_of(content)};
    while (count < boxes_per_node) {
      RangeNode divided = ranges[0];
      std::uint32_t from = 0;
      for (std::uint32_t slot = 1; slot < boxes_per_node; ++slot)
        if (slot < count && ranges[slot].shared_bits < divided.shared_bits) {
          divided = ranges[slot];
          from = slot;
        }
      if (divided.shared_bits == item_bits) break;
      const std::uint32_t children[] = {left(divided), right(divided)};
      const RangeNode of_children[] = {range_of(children[0]), range_of(children[1])};
      for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot)
        if (slot == from || slot == count) {
          held[slot] = children[slot == from ? 0 : 1];
          ranges[slot] = of_children[slot == from ? 0 : 1];
        }
      ++count;
    }
    Boxf of_slots[boxes_per_node];
    for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot)
      of_slots[slot] = boxes[held[slot < count ? slot : 0]];
    HierarchyNode node{};
    const NodeUnits units(boxes[content], node);
    node.first_node = begin_below + added(widths[level + 1], count);
    node.exponents |= ((1U << count) - 1) << 24;
    for (std::uint32_t slot = 0; slot < boxes_per_node; ++slot) {
      if (slot >= count) continue;
      units.add_planes(static_cast<int>(slot), of_slots[slot], node);
      node.slots[slot / 4] |= (node_slot | slot) << slot % 4 * 8;
      contents[node.first_node + slot] = held[slot];
    }
    nodes[number] = node;
    return count;
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
  const int levels = (static_cast<int>(std::bit_width(count)) + 2) / 3 + 1;
  // Of a binary node's eight boxes all are full, or all are items: so there are fewer than 4/7 nodes an item.
  auto nodes = executor.template array<HierarchyNode>(groups + count + std::uint64_t{count} * 4 / 7 + 1);
  auto roots = executor.template array<std::uint32_t>(groups);
  auto contents = executor.template array<std::uint32_t>(nodes.size());
  auto tree = executor.template array<RangeNode>(count);
  auto boxes = executor.template array<Boxf>(2 * std::uint64_t{count});
  auto parents = executor.template array<std::uint32_t>(2 * std::uint64_t{count});
  auto arrivals = executor.template array<std::uint32_t>(count);
  auto widths = executor.template array<std::uint32_t>(static_cast<std::uint64_t>(levels) + 1);
  const UpperArrays upper{{sorted.keys.data(), count},
                          sorted.values.data(),
                          tree.data(),
                          boxes.data(),
                          parents.data(),
                          arrivals.data(),
                          nodes.data(),
                          contents.data(),
                          widths.data()};
  executor.for_each(count > 0 ? count - 1 : 0,
                    [=] MASU_PASS(std::uint64_t i) { upper.add_tree_node(static_cast<std::uint32_t>(i)); });
  std::uint32_t* const root = roots.data();
  executor.for_each(std::uint64_t{count} + groups, [=] MASU_PASS(std::uint64_t i) {
    const auto item = static_cast<std::uint32_t>(i);
    if (i < count)
      upper.join_boxes(item, made.box(upper.items[item]));
    else
      root[i - count] = upper.add_root(static_cast<std::uint32_t>(i - count));
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
