// Small ranges of leaves split to their ends, a block of threads each: its nodes and what they cost, in
// memory that its threads share.
#pragma once

#include "libgrid/bits.h"
#include "libgrid/hierarchy/binary/split_ranges.h"
#include "libscene/base/atomic.h"

namespace masu {

inline constexpr std::uint32_t most_in_small = 256;

// A node's leaves, so many side by side in their order, and places after them for so many more; whether it is
// the right one of a pair, or the root; and its number among small ones, or its left child's among those of
// the next level.
struct LeafRange {
  std::uint32_t first, count, room, is_right, number_there;

  MASU_HD bool is_small() const { return count <= most_in_small; }
  // A pair of nodes that is split before leaf s is nodes 2 s and 2 s + 1: so a range has the numbers of all
  // nodes below its own to itself. The root is node 0, and 1 isn't there.
  MASU_HD std::uint32_t number() const {
    return is_right == 0 ? 2 * (first + count + room) : first > 0 ? 2 * first + 1 : 0;
  }
};

// A small range, with its depth.
struct SmallRange {
  std::uint32_t first, count, room, is_right, depth;
};

struct SplitSmallRanges {
  static constexpr unsigned threads = 128;                              // a block's,
  static constexpr unsigned threads_for_many = 16, threads_for_few = 4; // and those for a node
  static constexpr std::uint32_t most_nodes = 2 * most_in_small - 1;

  // A node of the range's: of `count` leaves from `first` on; its left child, which the right one follows.
  struct Node {
    std::uint16_t first, count, child;
  };
  struct Scratch {
    union { // first the ones, then the others
      SplitScratch splits[threads / threads_for_many];
      CollapseCosts costs[most_nodes]; // of the nodes
    };
    BinaryNode leaves[most_in_small];
    Node nodes[most_nodes]; // level by level
    std::uint16_t order[most_in_small], right[most_in_small];
    std::uint32_t node_count;
    std::uint16_t level_begin[max_hierarchy_depth + 2];
  };

  const BinaryNode* leaves;
  const std::uint32_t* order; // of leaves
  const SmallRange* ranges;
  BinaryNode* nodes; // by LeafRange::number()
  CollapseChoice* choices;
  CollapseCosts* costs; // of each range's node

  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    const SmallRange range = ranges[i];
    for (std::uint32_t k = group.thread_rank(); k < range.count; k += group.size()) {
      scratch.leaves[k] = leaves[order[range.first + k]];
      scratch.order[k] = static_cast<std::uint16_t>(k);
    }
    if (group.thread_rank() == 0) {
      scratch.nodes[0] = {0, static_cast<std::uint16_t>(range.count), 0};
      scratch.node_count = 1;
    }
    std::uint32_t level = 0, begin = 0, end = 1;
    for (; begin < end; ++level) {
      if (group.thread_rank() == 0) scratch.level_begin[level] = static_cast<std::uint16_t>(begin);
      group.sync();
      const std::uint32_t most = most_leaves_split(range.depth + level);
      split_nodes<threads_for_many>(group, scratch, begin, end, most);
      split_nodes<threads_for_few>(group, scratch, begin, end, most);
      group.sync();
      begin = end;
      end = scratch.node_count;
      group.sync();
    }
    for (; level-- > 0; end = begin) {
      begin = scratch.level_begin[level];
      for (std::uint32_t node = begin + group.thread_rank(); node < end; node += group.size())
        finish(scratch, range, node);
      group.sync();
    }
    if (group.thread_rank() == 0) costs[i] = scratch.costs[0];
  }

private:
  MASU_HD static const BinaryNode& leaf(const Scratch& scratch, std::uint32_t i) {
    return scratch.leaves[scratch.order[i]];
  }

  // A level's nodes of many leaves, or of few.
  template <unsigned width, class ThreadGroup>
  MASU_HD static void split_nodes(const ThreadGroup& group, Scratch& scratch, std::uint32_t begin,
                                  std::uint32_t end, std::uint32_t most) {
    constexpr bool are_few = width == threads_for_few;
    const auto tile = group.template tile<width>();
    const std::uint32_t rank = group.thread_rank() / tile.size(), tiles = group.size() / tile.size();
    for (std::uint32_t own = begin + rank; own < end; own += tiles) {
      Node& node = scratch.nodes[own];
      const std::uint32_t first = node.first, count = node.count;
      if (count == 1 || (count <= few_leaves) != are_few) continue;
      const auto leaf_of = [&](std::uint32_t i) -> const BinaryNode& { return leaf(scratch, first + i); };
      LeafSplit split;
      if (count > 2 && count <= most) {
        if constexpr (are_few)
          split = cheapest_split_of_few(tile, count, leaf_of);
        else // of all, wherever they may be
          split = cheapest_split(tile, scratch.splits[rank], count, {}, leaf_of);
      }
      std::uint32_t left = partition(tile, scratch, first, count, split);
      if (left == 0 || left == count) left = count / 2;
      if (tile.thread_rank() == 0) {
        const std::uint32_t child = added(scratch.node_count, 2);
        node.child = static_cast<std::uint16_t>(child);
        scratch.nodes[child] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(left), 0};
        scratch.nodes[child + 1] = {static_cast<std::uint16_t>(first + left),
                                    static_cast<std::uint16_t>(count - left), 0};
      }
    }
  }

  // Sorts a node's leaves: those on the left first, both in their order. Returns how many they are.
  template <class Tile>
  MASU_HD static std::uint32_t partition(const Tile& tile, Scratch& scratch, std::uint32_t first,
                                         std::uint32_t count, const LeafSplit& split) {
    if (split.axis < 0) return 0;
    std::uint32_t left = 0;
    for (std::uint32_t chunk = 0; chunk < count; chunk += tile.size()) {
      const std::uint32_t i = chunk + tile.thread_rank();
      const bool is_one = i < count, is_left = is_one && split.is_left(leaf(scratch, first + i));
      const std::uint16_t own = is_one ? scratch.order[first + i] : std::uint16_t{0};
      const std::uint32_t lefts = tile.ballot(is_left),
                          left_before = left + count_bits(lefts & ((1U << tile.thread_rank()) - 1));
      tile.sync(); // all have read what is written over
      if (is_one)
        (is_left ? scratch.order[first + left_before] : scratch.right[first + i - left_before]) = own;
      left += count_bits(lefts);
      tile.sync();
    }
    for (std::uint32_t i = tile.thread_rank(); i < count - left; i += tile.size())
      scratch.order[first + left + i] = scratch.right[first + i];
    tile.sync();
    return left;
  }

  MASU_HD void finish(Scratch& scratch, const SmallRange& range, std::uint32_t own) const {
    const std::uint32_t first = scratch.nodes[own].first, count = scratch.nodes[own].count,
                        child = scratch.nodes[own].child;
    const LeafRange whole{range.first + first, count, own == 0 ? range.room : 0,
                          own == 0 ? range.is_right : 1 - own % 2, 0};
    BinaryNode node;
    if (count == 1) {
      node = leaf(scratch, first);
      scratch.costs[own] = collapse_costs_of_leaf(node);
    } else {
      const std::uint32_t pair = 2 * (whole.first + scratch.nodes[child].count);
      const BinaryNode &left = nodes[pair], &right = nodes[pair + 1];
      node = node_of(join(left.box(), right.box()), pair, left, right);
      scratch.costs[own] = collapse_costs(node, scratch.costs[child], scratch.costs[child + 1]);
    }
    nodes[whole.number()] = node;
    choices[whole.number()] = scratch.costs[own].choice;
  }
};

} // namespace masu
