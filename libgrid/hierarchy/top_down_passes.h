// A binary hierarchy from the root down, on whatever executor (executor.h): level by level, each node's
// leaves as leaf_split.h has it. The CPU builds the same one depth first (top_down_host.h).
//
//   1. split    of each node's leaves by where their centres are
//   2. sort     each node's leaves, in its place, by the node of the next level that they are in, else in
//               their order; 1 and 2 until each is alone
//   3. combine  boxes and costs, from the lowest level up
//
// No byte of the result depends on the executor or its number of threads.
#pragma once

#include "libgrid/hierarchy/combine_passes.h"
#include "libgrid/hierarchy/leaf_split.h"
#include "libscene/passes/thread_group.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

// A node's leaves, so many side by side in their order; of a single one `first` is its number.
struct LeafRange {
  std::uint32_t first, count;
};

struct SplitRanges {
  struct Scratch {
    Boxf centres;
    struct {
      Boxf box;
      std::uint32_t count;
    } bins[3][max_bins];
  };
  const BinaryNode* leaves;
  const std::uint32_t* order; // of leaves
  const LeafRange* ranges;
  const Boxf* spaces;
  LeafSplit* splits;
  std::uint32_t most; // a range of more is halved, lest the hierarchy become too deep

  MASU_HD std::uint32_t size(std::uint64_t i) const {
    return std::min(ranges[i].count, std::uint32_t{LeafSample::most});
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    const LeafRange range = ranges[i];
    LeafSplit best;
    if (range.count > 2 && range.count <= most)
      best = range.count <= few_leaves ? cheapest_of_few(group, range)
                                       : cheapest(group, scratch, range, spaces[i]);
    if (group.thread_rank() == 0) splits[i] = best;
  }

private:
  MASU_HD const BinaryNode& leaf(const LeafRange& range, std::uint32_t i) const {
    return leaves[order[range.first + i]];
  }
  MASU_HD static float cost_of(const Boxf& left, std::uint32_t left_count, const Boxf& right,
                               std::uint32_t right_count) {
    return split_cost(half_area(left), static_cast<float>(left_count), half_area(right),
                      static_cast<float>(right_count));
  }

  // Of any of a range's leaves as the last one on the left, sorted along each axis. Both for the first
  // thread.
  template <class ThreadGroup>
  MASU_HD LeafSplit cheapest_of_few(const ThreadGroup& group, const LeafRange& range) const {
    LeafSplit best;
    for (auto axis = static_cast<int>(group.thread_rank()); axis < 3;
         axis += static_cast<int>(group.size())) {
      float centres[few_leaves];
      Boxf boxes[few_leaves], right[few_leaves];
      for (std::uint32_t i = 0; i < range.count; ++i) {
        const BinaryNode& own = leaf(range, i);
        const float centre = twice_the_centre(own, axis);
        std::uint32_t to = i;
        for (; to > 0 && centre < centres[to - 1]; --to) {
          centres[to] = centres[to - 1];
          boxes[to] = boxes[to - 1];
        }
        centres[to] = centre;
        boxes[to] = own.box();
      }
      right[range.count - 1] = boxes[range.count - 1];
      for (std::uint32_t i = range.count - 1; i-- > 1;)
        right[i] = join(boxes[i], right[i + 1]);
      LeafSplit split;
      split.axis = axis;
      Boxf left = empty_box<float>();
      for (std::uint32_t i = 0; i + 1 < range.count; ++i) {
        left = join(left, boxes[i]);
        if (centres[i] == centres[i + 1]) continue;
        split.cost = cost_of(left, i + 1, right[i + 1], range.count - i - 1);
        split.place = centres[i];
        if (comes_before(split, best)) best = split;
      }
    }
    return group.first_of_all(best);
  }

  template <class ThreadGroup>
  MASU_HD LeafSplit cheapest(const ThreadGroup& group, Scratch& scratch, const LeafRange& range,
                             const Boxf& space) const {
    const LeafSample sample(range.count);
    const auto for_each_leaf = [&](const auto& act) {
      sample.for_each(group.thread_rank(), group.size(),
                      [&](std::uint32_t i, std::uint32_t stands_for) { act(leaf(range, i), stands_for); });
    };
    if (group.thread_rank() == 0) scratch.centres = empty_box<float>();
    const std::int32_t bins = bin_count(range.count);
    for (auto i = static_cast<std::int32_t>(group.thread_rank()); i < 3 * bins;
         i += static_cast<std::int32_t>(group.size())) {
      auto& bin = scratch.bins[i / bins][i % bins];
      bin.box = empty_box<float>();
      bin.count = 0;
    }
    group.sync();
    Boxf own = empty_box<float>();
    for_each_leaf([&](const BinaryNode& leaf, std::uint32_t) { own = join(own, leaf.min + leaf.max); });
    group.join(scratch.centres, own);
    group.sync();
    const LeafBins along[] = {{sample, scratch.centres, space, 0},
                              {sample, scratch.centres, space, 1},
                              {sample, scratch.centres, space, 2}};
    for_each_leaf([&](const BinaryNode& leaf, std::uint32_t stands_for) {
      for (int axis = 0; axis < 3; ++axis) {
        auto& bin = scratch.bins[axis][along[axis](twice_the_centre(leaf, axis))];
        group.join(bin.box, leaf.box());
        group.count(bin.count, stands_for);
      }
    });
    group.sync();
    LeafSplit best;
    for (auto axis = static_cast<int>(group.thread_rank()); axis < 3;
         axis += static_cast<int>(group.size())) {
      const LeafSplit split = cheapest_along(axis, along[axis], scratch, range.count);
      if (comes_before(split, best)) best = split;
    }
    return group.first_of_all(best);
  }

  MASU_HD static LeafSplit cheapest_along(int axis, const LeafBins& along, const Scratch& scratch,
                                          std::uint32_t count) {
    const auto& bins = scratch.bins[axis];
    Boxf right[max_bins + 1]; // of all from a bin on
    right[along.count] = empty_box<float>();
    for (int bin = along.count; --bin > 0;)
      right[bin] = join(right[bin + 1], bins[bin].box);
    LeafSplit best, split;
    split.axis = axis;
    Boxf left = empty_box<float>();
    std::uint32_t left_count = 0;
    for (int bin = 0; bin + 1 < along.count; ++bin) {
      left = join(left, bins[bin].box);
      left_count += bins[bin].count;
      if (left_count == 0) continue;
      if (left_count == count) break;
      split.cost = cost_of(left, left_count, right[bin + 1], count - left_count);
      split.place = along.end(bin);
      if (comes_before(split, best)) best = split;
    }
    return best;
  }
};

// A level's nodes as combined() asks for them (combine_passes.h).
struct SplitNodes {
  const BinaryNode* leaves;
  const LeafRange* ranges;
  const std::uint32_t* first_children;

  MASU_HD bool is_leaf(std::uint64_t i) const { return ranges[i].count == 1; }
  MASU_HD const BinaryNode& leaf(std::uint64_t i) const { return leaves[ranges[i].first]; }
  MASU_HD std::uint32_t first_child(std::uint64_t i) const { return first_children[i]; }
  MASU_HD Boxf box(std::uint64_t, const BinaryNode& left, const BinaryNode& right) const {
    return join(left.box(), right.box());
  }
};

// Nodes of one depth. The children of the first are the first two of the next level, and so on.
template <class Executor>
struct BinaryLevel {
  const BinaryNode* leaves = nullptr; // of all levels
  ArrayOf<Executor, LeafRange> ranges{};
  ArrayOf<Executor, Boxf> spaces{}; // in which twice the centres of a range's leaves are; until it is split
  ArrayOf<Executor, std::uint32_t> first_child{};

  SplitNodes split_nodes() const { return {leaves, ranges.data(), first_child.data()}; }
};

// Leaves sorted by their ranges in a level. What is in the place of one that is alone isn't read any more,
// but for its range: none.
template <class Executor>
struct LeafOrder {
  static constexpr std::uint32_t none = ~0U;
  ArrayOf<Executor, std::uint32_t> leaves{}, ranges{};

  LeafOrder(const Executor& executor, std::uint64_t count)
      : leaves(executor.template array<std::uint32_t>(count)),
        ranges(executor.template array<std::uint32_t>(count)) {}
};

// Splits a level's ranges and sorts the leaves anew; returns the next level.
template <class Executor>
BinaryLevel<Executor> split_level(Executor& executor, std::uint32_t most, BinaryLevel<Executor>& level,
                                  LeafOrder<Executor>& order) {
  constexpr std::uint32_t none = LeafOrder<Executor>::none;
  const std::uint64_t range_count = level.ranges.size(), count = order.leaves.size();
  auto splits = executor.template array<LeafSplit>(range_count);
  const BinaryNode* const leaf = level.leaves;
  const std::uint32_t *const ordered_leaf = order.leaves.data(), *const range_of = order.ranges.data();
  const LeafRange* const range = level.ranges.data();
  const Boxf* const space = level.spaces.data();
  LeafSplit* const split = splits.data();
  executor.for_each_by_group(range_count, SplitRanges{leaf, ordered_leaf, range, space, split, most});
  level.first_child = sums_before(executor, range_count,
                                  [=] MASU_PASS(std::uint64_t i) { return range[i].count > 1 ? 2U : 0U; });
  const auto left_sums = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    return own != none && split[own].is_left(leaf[ordered_leaf[i]]);
  });
  const std::uint32_t *const first_child = level.first_child.data(), *const left_before = left_sums.data();
  const std::uint64_t child_count = executor.value(level.first_child, range_count);
  BinaryLevel<Executor> below{leaf, executor.template array<LeafRange>(child_count),
                              executor.template array<Boxf>(child_count)};
  LeafRange* const child = below.ranges.data();
  Boxf* const child_space = below.spaces.data();
  executor.for_each(range_count, [=] MASU_PASS(std::uint64_t i) {
    const auto [first, in_range] = range[i];
    if (in_range == 1) return;
    std::uint32_t left = left_before[first + in_range] - left_before[first];
    if (left == 0 || left == in_range) {
      split[i].axis = -1;
      left = in_range / 2;
    }
    const std::uint32_t at = first_child[i];
    child[at] = {first, left};
    child[at + 1] = {first + left, in_range - left};
    const SplitSpaces spaces(space[i], split[i]);
    child_space[at] = spaces.left;
    child_space[at + 1] = spaces.right;
  });
  LeafOrder<Executor> next(executor, count);
  std::uint32_t *const next_leaf = next.leaves.data(), *const next_range_of = next.ranges.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    if (own == none) {
      next_range_of[i] = none;
      return;
    }
    const std::uint32_t first = range[own].first, left_child = first_child[own],
                        in_range = static_cast<std::uint32_t>(i) - first;
    const std::uint32_t in_left = child[left_child].count;
    const bool halved = split[own].axis < 0;
    const std::uint32_t left =
        halved ? std::min(in_range, in_left) : left_before[i] - left_before[first]; // before it
    const bool is_left = halved ? in_range < in_left : left_before[i + 1] != left_before[i];
    const std::uint32_t to = left_child + (is_left ? 0 : 1),
                        at = first + (is_left ? left : in_left + in_range - left);
    const bool is_alone = child[to].count == 1;
    next_range_of[at] = is_alone ? none : to;
    next_leaf[at] = ordered_leaf[i];
    if (is_alone) child[to].first = ordered_leaf[i];
  });
  order = std::move(next);
  level.spaces = {};
  return below;
}

template <class Executor>
BinaryHierarchy<Executor> top_down_hierarchy(Executor& executor, const ArrayOf<Executor, BinaryNode>& leaves,
                                             const Boxd& scene_space) {
  const std::uint64_t count = leaves.size();
  if (count == 0) return {};
  LeafOrder<Executor> order(executor, count > 1 ? count : 0);
  std::uint32_t *const ordered_leaf = order.leaves.data(), *const range_of = order.ranges.data();
  executor.for_each(order.leaves.size(), [=] MASU_PASS(std::uint64_t i) {
    ordered_leaf[i] = static_cast<std::uint32_t>(i);
    range_of[i] = 0;
  });
  BinaryLevel<Executor> next{leaves.data(), executor.template array<LeafRange>(1),
                             executor.template array<Boxf>(1)};
  LeafRange* const all = next.ranges.data();
  Boxf* const space = next.spaces.data();
  executor.for_each(1, [=, centres = twice(cast<float>(scene_space))] MASU_PASS(std::uint64_t) {
    *all = {0, static_cast<std::uint32_t>(count)};
    *space = centres;
  });
  std::vector<BinaryLevel<Executor>> levels;
  while (next.ranges.size() > 0) {
    const std::uint32_t most = most_leaves_split(levels.size());
    levels.push_back(std::move(next));
    next = split_level(executor, most, levels.back(), order);
  }
  return combined(executor, std::move(levels));
}

} // namespace masu
