// A binary hierarchy from the root down, on whatever executor (executor.h): level by level, each node's
// leaves as leaf_split.h has it. The CPU builds the same one depth first (binary_hierarchy.h).
//
//   1. split    of each node's leaves by where their centres are
//   2. divide   what is large by a plane, where that is cheaper (large_leaves.h)
//   3. sort     each node's leaves, in its place, by the node of the next level that they are in, else in
//               their order; 1 to 3 until all ranges are small. Where a level's are small enough, and
//               nothing is divided, a block of threads does 1 and 3 to each (SortRanges)
//   4. finish   small ranges, with all that is below them (small_ranges.h)
//   5. combine  boxes and costs, from the lowest level up
//
// No byte of the result depends on the executor or its number of threads.
#pragma once

#include "libgrid/hierarchy/binary/combine_passes.h"
#include "libgrid/hierarchy/binary/level_splits.h"
#include "libgrid/hierarchy/binary/small_ranges.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

// A level's nodes as combine() asks for them (combine_passes.h).
struct SplitNodes {
  const LeafRange* ranges;
  LevelCount count;
  const std::uint32_t* pairs;
  const CollapseCosts* small_costs;

  MASU_HD void combine(std::uint64_t i, const CombinedNodes& to) const {
    if (i >= count()) return;
    const LeafRange own = ranges[i];
    if (own.is_small()) {
      to.costs[i] = small_costs[own.number_there];
      return;
    }
    const Boxf box = join(to.nodes[pairs[i]].box(), to.nodes[pairs[i] + 1].box());
    to.put_parent(i, own.number(), box, own.number_there, pairs[i]);
  }
};

// Nodes of one depth, in any order. There may be room for more than there are.
template <class Executor>
struct RangeLevel {
  LevelCount count{};
  ArrayOf<Executor, LeafRange> ranges{};
  ArrayOf<Executor, Boxf> spaces{}; // in which twice the centres of a range's leaves are; until it is split
  ArrayOf<Executor, std::uint32_t> pairs{};   // the numbers of their left children
  const CollapseCosts* small_costs = nullptr; // of all levels' small ranges

  SplitNodes split_nodes() const { return {ranges.data(), count, pairs.data(), small_costs}; }
};

// Leaves sorted by their ranges in a level; by no_range, those of small ones.
template <class Executor>
struct LeafOrder {
  ArrayOf<Executor, std::uint32_t> leaves{}, ranges{};
};

// Divides what is large at the planes that ranges of a level are split at: of each range the first leaves
// that are, as long as there is room. What lies below stays in its place, what lies above comes after the
// range's others. `leaf`: all, and places for more.
template <class Executor>
void divide_large(Executor& executor, BinaryNode* leaf, const SplitAtPlanes& at, RangeLevel<Executor>& level,
                  const LeafOrder<Executor>& order) {
  const std::uint64_t range_count = level.ranges.size(), places = order.leaves.size();
  LeafRange* const range = level.ranges.data();
  const std::uint32_t *const ordered_leaf = order.leaves.data(), *const range_of = order.ranges.data();
  const auto divided = sums_before(executor, places, [=] MASU_PASS(std::uint64_t i) {
    Sides parts{};
    return at.divides(i, range_of[i], parts);
  });
  const std::uint32_t* const divided_before = divided.data();
  executor.for_each(places, [=] MASU_PASS(std::uint64_t i) {
    if (divided_before[i + 1] == divided_before[i]) return;
    const LeafRange own = range[range_of[i]];
    const std::uint32_t before = divided_before[i] - divided_before[own.first];
    Sides parts{};
    if (before >= own.room || !at.divides(i, range_of[i], parts)) return;
    put_parts(parts, 1, leaf[ordered_leaf[i]], leaf[ordered_leaf[own.first + own.count + before]]);
  });
  executor.for_each(range_count, [=, there = level.count] MASU_PASS(std::uint64_t i) {
    if (i >= there() || range[i].is_small()) return;
    const std::uint32_t first = range[i].first, end = first + range[i].count;
    const std::uint32_t more = std::min(divided_before[end] - divided_before[first], range[i].room);
    range[i].count += more;
    range[i].room -= more;
  });
}

// Splits the ranges of a level of that depth and sorts the leaves anew; returns the next level. Where that
// may have as many ranges as there is room for, the host doesn't wait to be told.
template <class Executor>
RangeLevel<Executor> split_level(Executor& executor, BinaryNode* leaf, const LargeLeaves& large,
                                 const TrianglesOfEither& triangle, std::uint32_t depth,
                                 RangeLevel<Executor>& level, LeafOrder<Executor>& order,
                                 LeafOrder<Executor>& next, const RangeNumbers& numbers,
                                 const ArrayOf<Executor, std::uint32_t>& counts, bool by_blocks) {
  const std::uint64_t range_count = level.ranges.size(), count = order.leaves.size();
  const LeafRange* const range = level.ranges.data();
  const LevelCount ranges_there = level.count;
  const std::uint64_t most_large = count / (most_in_small + 1);
  const bool may_be_full = most_large >> depth > 0;
  const std::uint64_t child_count = may_be_full ? 2 * std::min(range_count, most_large)
                                                : executor.value(counts, RangeNumbers::place(depth + 1));
  RangeLevel<Executor> below{{child_count, counts.data() + RangeNumbers::place(depth + 1)},
                             executor.template array<LeafRange>(child_count),
                             executor.template array<Boxf>(child_count)};
  if (child_count == 0) return below;
  auto splits = executor.template array<LeafSplit>(range_count);
  level.pairs = executor.template array<std::uint32_t>(range_count);
  const std::uint32_t *const ordered_leaf = order.leaves.data(), *const range_of = order.ranges.data();
  const Boxf* const space = level.spaces.data();
  LeafSplit* const split = splits.data();
  const SplitRanges split_ranges{
      leaf, ordered_leaf, range, ranges_there, space, split, most_leaves_split(depth)};
  const RangesBelow to{below.ranges.data(), below.spaces.data(), level.pairs.data(), numbers, depth + 1};
  if (by_blocks) {
    executor.for_each_by_group(range_count,
                               SortRanges{split_ranges, order.leaves.data(), next.leaves.data(), to});
    level.spaces = {};
    return below;
  }
  executor.for_each_by_group(range_count, split_ranges);
  if (large.room > 0) {
    auto at_plane = executor.template array<std::uint32_t>(range_count);
    const SplitAtPlanes at_planes{split_ranges, large, triangle, at_plane.data()};
    executor.for_each_by_group(range_count, at_planes);
    divide_large(executor, leaf, at_planes, level, order);
  }
  const auto left_sums = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    return own != no_range && split[own].is_left(leaf[ordered_leaf[i]]);
  });
  const std::uint32_t* const left_before = left_sums.data();
  const LeafRange* const child = below.ranges.data();
  executor.for_each(range_count, [=] MASU_PASS(std::uint64_t i) {
    if (i >= ranges_there() || range[i].is_small()) return;
    const std::uint32_t first = range[i].first, end = first + range[i].count;
    to.put(i, range[i], left_before[end] - left_before[first], space[i], split[i]);
  });
  executor.for_each(count, [=, next_leaf = next.leaves.data(),
                            next_range_of = next.ranges.data()] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    if (own == no_range) {
      next_range_of[i] = no_range;
      next_leaf[i] = ordered_leaf[i];
      return;
    }
    const std::uint32_t first = range[own].first, left_child = range[own].number_there,
                        in_range = static_cast<std::uint32_t>(i) - first;
    const LeafRange on_left = child[left_child], on_right = child[left_child + 1];
    const bool halved = split[own].axis < 0;
    const std::uint32_t left =
        halved ? std::min(in_range, on_left.count) : left_before[i] - left_before[first]; // before it
    bool is_left = halved ? in_range < on_left.count : left_before[i + 1] != left_before[i];
    std::uint32_t at = is_left ? first + left : on_right.first + in_range - left;
    if (const std::uint32_t end = on_right.first + on_right.count + on_right.room; at >= end) {
      is_left = true; // a place for more
      at = first + on_left.count + (at - end);
    }
    next_range_of[at] = (is_left ? on_left : on_right).is_small() ? no_range : left_child + (is_left ? 0 : 1);
    next_leaf[at] = ordered_leaf[i];
  });
  std::swap(order, next);
  level.spaces = {};
  return below;
}

// With places for so many more, which are on no side of anything.
template <class Executor>
ArrayOf<Executor, BinaryNode> with_room(Executor& executor, const ArrayOf<Executor, BinaryNode>& leaves,
                                        std::uint32_t room) {
  const std::uint64_t count = leaves.size();
  auto all = executor.template array<BinaryNode>(count + room);
  executor.for_each(count + room, [=, to = all.data(), leaf = leaves.data()] MASU_PASS(std::uint64_t i) {
    constexpr Vec3f nowhere{INFINITY, INFINITY, INFINITY};
    to[i] = i < count ? leaf[i] : BinaryNode{nowhere, 0, nowhere, 1};
  });
  return all;
}

template <class Executor>
BinaryHierarchy<Executor> top_down_hierarchy(Executor& executor, HierarchyLeaves<Executor> made,
                                             const TrianglesOfEither& triangle, const Boxd& scene_space) {
  auto& [leaves, large] = made;
  if (leaves.size() == 0) return {};
  if (large.room > 0) leaves = with_room(executor, leaves, large.room);
  const std::uint64_t count = leaves.size();
  BinaryNode* const leaf = leaves.data();
  const auto order_of_all = [&]() -> LeafOrder<Executor> {
    return {executor.template array<std::uint32_t>(count), executor.template array<std::uint32_t>(count)};
  };
  LeafOrder<Executor> order = order_of_all(), next_order = order_of_all();
  const bool is_small = count - large.room <= most_in_small;
  executor.for_each(count, [=, ordered_leaf = order.leaves.data(),
                            range_of = order.ranges.data()] MASU_PASS(std::uint64_t i) {
    ordered_leaf[i] = static_cast<std::uint32_t>(i);
    range_of[i] = is_small ? no_range : 0;
  });
  // Each small range is a part of one that isn't, of which no level has more than fit into all leaves.
  auto small = executor.template array<SmallRange>(2 * (max_hierarchy_depth * count / most_in_small + 1));
  constexpr std::uint32_t depths = max_hierarchy_depth + 3;
  auto counts = executor.template zeros<std::uint32_t>(2 * depths);
  const RangeNumbers numbers{small.data(), counts.data(), counts.data() + depths};
  RangeLevel<Executor> next{
      {1, nullptr}, executor.template array<LeafRange>(1), executor.template array<Boxf>(1)};
  executor.for_each(1, [=, all = next.ranges.data(), space = next.spaces.data(), room = large.room,
                        centres = twice(cast<float>(scene_space))] MASU_PASS(std::uint64_t) {
    *all = numbers.numbered(0, static_cast<std::uint32_t>(count) - room, room, true, 0);
    *space = centres;
  });
  std::vector<RangeLevel<Executor>> levels;
  bool by_blocks = large.room == 0 && count <= most_sorted_by_block;
  while (next.ranges.size() > 0) {
    const auto depth = static_cast<std::uint32_t>(levels.size());
    if (!by_blocks && large.room == 0 && 2 * (count >> depth) <= most_sorted_by_block)
      by_blocks = executor.value(counts, depths + depth) <= most_sorted_by_block;
    levels.push_back(std::move(next));
    next = split_level(executor, leaf, large, triangle, depth, levels.back(), order, next_order, numbers,
                       counts, by_blocks);
  }
  next_order = {};
  const std::uint32_t small_count = executor.value(counts, 0);
  auto small_costs = executor.template array<CollapseCosts>(small_count);
  BinaryHierarchy<Executor> hierarchy{executor.template array<BinaryNode>(2 * count),
                                      executor.template array<CollapseChoice>(2 * count)};
  executor.for_each_by_group(small_count,
                             SplitSmallRanges{leaf, order.leaves.data(), small.data(), hierarchy.nodes.data(),
                                              hierarchy.choices.data(), small_costs.data()});
  for (RangeLevel<Executor>& level : levels)
    level.small_costs = small_costs.data();
  combine(executor, std::move(levels), hierarchy);
  return hierarchy;
}

} // namespace masu
