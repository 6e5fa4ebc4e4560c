// Small ranges of leaves split to their ends, a block of threads each: its nodes and what they cost, in
// memory that its threads share.
#pragma once

#include "libgrid/bits.h"
#include "libgrid/hierarchy/split_ranges.h"
#include "libscene/base/atomic.h"

#include <algorithm>

namespace masu {

inline constexpr std::uint32_t most_in_small = 256;

// A node's leaves, so many side by side in their order; whether it is the right one of a pair, or the root;
// and where it is small its number among those that are.
struct LeafRange {
  std::uint32_t first, count, is_right, small;

  MASU_HD bool is_small() const { return count <= most_in_small; }
  // A pair of nodes that is split before leaf s is nodes 2 s and 2 s + 1: so a range has the numbers of all
  // nodes below its own to itself. The root is node 0, and 1 isn't there.
  MASU_HD std::uint32_t number() const {
    return is_right == 0 ? 2 * (first + count) : first > 0 ? 2 * first + 1 : 0;
  }
};

// A small range, with its depth.
struct SmallRange {
  std::uint32_t first, count, is_right, depth;
};

struct SplitSmallRanges {
  static constexpr unsigned threads = 256; // a block's
  static constexpr std::uint32_t most_nodes = 2 * most_in_small - 1;

  // A node of the range's: of `count` leaves from `first` on; its left child, which the right one follows.
  struct Node {
    std::uint16_t first, count, child;
  };
  struct Scratch {
    union { // first the ones, then the others
      SplitScratch splits[threads / threads_per_tile];
      CollapseCosts costs[most_nodes]; // of the nodes
    };
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
    for (std::uint32_t k = group.thread_rank(); k < range.count; k += group.size())
      scratch.order[k] = static_cast<std::uint16_t>(k);
    if (group.thread_rank() == 0) {
      scratch.nodes[0] = {0, static_cast<std::uint16_t>(range.count), 0};
      scratch.node_count = 1;
    }
    std::uint32_t level = 0, begin = 0, end = 1;
    for (; begin < end; ++level) {
      if (group.thread_rank() == 0) scratch.level_begin[level] = static_cast<std::uint16_t>(begin);
      group.sync();
      split_level(group, scratch, range, begin, end, most_leaves_split(range.depth + level));
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
  MASU_HD const BinaryNode& leaf(const Scratch& scratch, const SmallRange& range, std::uint32_t i) const {
    return leaves[order[range.first + scratch.order[i]]];
  }

  template <class ThreadGroup>
  MASU_HD void split_level(const ThreadGroup& group, Scratch& scratch, const SmallRange& range,
                           std::uint32_t begin, std::uint32_t end, std::uint32_t most) const {
    const auto tile = group.tile();
    SplitScratch& split_scratch = scratch.splits[group.tile_rank()];
    for (std::uint32_t own = begin + group.tile_rank(); own < end; own += group.tile_count()) {
      Node& node = scratch.nodes[own];
      const std::uint32_t first = node.first, count = node.count;
      if (count == 1) continue;
      const auto leaf_of = [&](std::uint32_t i) -> const BinaryNode& {
        return leaf(scratch, range, first + i);
      };
      LeafSplit split;
      if (count > 2 && count <= most) // all are looked at, wherever they may be
        split = SplitOfRange{tile, split_scratch, count, leaf_of}.cheapest({});
      std::uint32_t left = partition(tile, scratch, range, first, count, split);
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
  MASU_HD std::uint32_t partition(const Tile& tile, Scratch& scratch, const SmallRange& range,
                                  std::uint32_t first, std::uint32_t count, const LeafSplit& split) const {
    if (split.axis < 0) return 0;
    std::uint32_t left = 0;
    for (std::uint32_t chunk = 0; chunk < count; chunk += tile.size()) {
      const std::uint32_t i = chunk + tile.thread_rank();
      const bool is_one = i < count, is_left = is_one && split.is_left(leaf(scratch, range, first + i));
      const std::uint16_t own = is_one ? scratch.order[first + i] : std::uint16_t{0};
      const std::uint32_t lefts = tile.all_bits(is_left ? 1U << tile.thread_rank() : 0U),
                          left_before = left + count_bits(lefts & ((1U << tile.thread_rank()) - 1));
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
    const LeafRange whole{range.first + first, count, own == 0 ? range.is_right : 1 - own % 2, 0};
    BinaryNode node;
    if (count == 1) {
      node = leaf(scratch, range, first);
      scratch.costs[own] = collapse_costs_of_leaf(node);
    } else {
      const std::uint32_t pair = 2 * (whole.first + scratch.nodes[child].count);
      const Boxf box = join(nodes[pair].box(), nodes[pair + 1].box());
      node = {box.min, pair, box.max, count};
      scratch.costs[own] = collapse_costs(node, scratch.costs[child], scratch.costs[child + 1]);
    }
    nodes[whole.number()] = node;
    choices[whole.number()] = scratch.costs[own].choice;
  }
};

} // namespace masu
