// A binary hierarchy of high quality from the root down, on whatever executor (executor.h): level by level,
// each node's fragments as fragment_split.h has it. The CPU builds the same one depth first
// (binary_hierarchy.h).
//
//   1. extents  of each node's fragments, and of their centres
//   2. objects  the cheapest split by centres
//   3. space    where that leaves boxes that overlap, the cheapest by planes
//   4. divide   what crosses the planes, as long as a node has room for more
//   5. sort     fragments by the node of the next level that they are in; 1 to 5 until each is alone
//   6. combine  nodes and costs, from the lowest level up
//
// No byte of the result depends on the executor or its number of threads: boxes are joined and fragments
// counted, which comes to the same in any order.
#pragma once

#include "libgrid/hierarchy/binary/fragment_split_passes.h"
#include "libgrid/hierarchy/hierarchy_builder.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

// Divides what crosses the planes of splits: of each range the first ones that do, as long as there is room.
// What lies below stays in its place, what lies above comes after the range's others.
template <class Executor, class Stored>
void divide(Executor& executor, const SceneView<Stored>& scene, double margin,
            const ArrayOf<Executor, RangeSplit>& splits, FragmentLevel<Executor>& level,
            FragmentOrder<Executor>& order) {
  const std::uint64_t range_count = level.ranges.size(), count = order.fragments.size();
  FragmentRange* const range = level.ranges.data();
  const RangeSplit* const split = splits.data();
  const BinaryNode* const fragment = order.fragments.data();
  const std::uint32_t* const range_of = order.ranges.data();
  const auto crossing = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) {
    Sides parts{};
    return split[range_of[i]].divides(scene, margin, fragment[i], parts);
  });
  const std::uint32_t* const crossing_before = crossing.data();
  const auto added = sums_before(executor, range_count, [=] MASU_PASS(std::uint64_t i) {
    const auto [first, in_range, room] = range[i];
    if (in_range == 1) return 0U;
    return std::min(crossing_before[first + in_range] - crossing_before[first], room);
  });
  const std::uint32_t all_added = executor.value(added, range_count);
  if (all_added == 0) return;
  const std::uint32_t* const added_before = added.data();
  FragmentOrder<Executor> divided{executor.template array<BinaryNode>(count + all_added),
                                  executor.template array<std::uint32_t>(count + all_added)};
  executor.for_each(
      count, [=, to = divided.fragments.data(), to_range = divided.ranges.data()] MASU_PASS(std::uint64_t i) {
        const std::uint32_t own = range_of[i];
        const auto [first, in_range, room] = range[own];
        const std::uint64_t at = i + added_before[own];
        const std::uint32_t before = crossing_before[i] - crossing_before[first];
        BinaryNode whole = fragment[i];
        to_range[at] = own;
        Sides parts{};
        if (crossing_before[i + 1] != crossing_before[i] && before < room &&
            split[own].divides(scene, margin, whole, parts)) {
          const std::uint64_t above = std::uint64_t{first} + added_before[own] + in_range + before;
          put_parts(parts, 1, whole, to[above]);
          to_range[above] = own;
        }
        to[at] = whole;
      });
  executor.for_each(range_count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t more = added_before[i + 1] - added_before[i];
    range[i].first += added_before[i];
    range[i].count += more;
    range[i].room -= more;
  });
  order = std::move(divided);
}

// Where a range's fragments come to lie that are partitioned in place, as std::partition() does on the host:
// the first one that belongs to the right changes places with the last one that belongs to the left, and so
// on. `left_before`: each of the range's fragments, and all.
MASU_HD inline std::uint32_t partitioned_place(const std::uint32_t* left_before, std::uint32_t count,
                                               std::uint32_t left, std::uint32_t i) {
  const auto lefts = [=](std::uint32_t k) { return left_before[k] - left_before[0]; };
  const bool is_left = left_before[i + 1] != left_before[i];
  if (is_left == (i < left)) return i;
  if (is_left)
    return last_not_above(left, left - 1 - lefts(i), [=](std::uint32_t k) { return k - lefts(k); });
  return last_not_above(count, left - 1 - (i - lefts(i)), lefts);
}

// Sorts fragments by the ranges of the next level, which it returns, and its sums.
template <class Executor>
FragmentLevel<Executor> next_level(Executor& executor, ArrayOf<Executor, RangeSplit>& splits,
                                   const FragmentLevel<Executor>& level, std::uint32_t child_count,
                                   FragmentOrder<Executor>& order, RangeSums& all) {
  const std::uint64_t range_count = level.ranges.size(), count = order.fragments.size();
  const FragmentRange* const range = level.ranges.data();
  const RangeSums* const before = level.before.data();
  RangeSplit* const split = splits.data();
  const BinaryNode* const fragment = order.fragments.data();
  const std::uint32_t* const range_of = order.ranges.data();
  const auto lefts = sums_before(
      executor, count, [=] MASU_PASS(std::uint64_t i) { return split[range_of[i]].is_left(fragment[i]); });
  const std::uint32_t* const left_before = lefts.data();
  FragmentLevel<Executor> below{executor.template array<FragmentRange>(child_count),
                                executor.template array<BinaryNode>(child_count)};
  FragmentRange* const child = below.ranges.data();
  executor.for_each(range_count, [=] MASU_PASS(std::uint64_t i) {
    const auto [first, in_range, room] = range[i];
    if (in_range == 1) return;
    std::uint32_t left = left_before[first + in_range] - left_before[first];
    // Parts within the margin of an older plane may all come to lie on one side.
    if (left == 0 || left == in_range) {
      split[i].kind = SplitKind::halves;
      left = in_range / 2;
    }
    const std::uint32_t at = before[i].children, left_room = room_of_left(room, left, in_range);
    child[at] = {0, left, left_room};
    child[at + 1] = {0, in_range - left, room - left_room};
  });
  all = sum_ranges(executor, below);
  executor.for_each(child_count, [=, child_before = below.before.data()] MASU_PASS(std::uint64_t i) {
    child[i].first = child_before[i].fragments;
  });
  FragmentOrder<Executor> next{executor.template array<BinaryNode>(all.fragments),
                               executor.template array<std::uint32_t>(all.fragments)};
  executor.for_each(count, [=, alone = below.nodes.data(), to = next.fragments.data(),
                            to_range = next.ranges.data()] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    const auto [first, in_range, room] = range[own];
    std::uint32_t own_child = before[own].children, place = static_cast<std::uint32_t>(i) - first;
    const std::uint32_t left = child[own_child].count;
    if (split[own].kind != SplitKind::halves)
      place = partitioned_place(left_before + first, in_range, left, place);
    if (place >= left) {
      ++own_child;
      place -= left;
    }
    if (child[own_child].count == 1) {
      alone[own_child] = fragment[i];
      return;
    }
    to[child[own_child].first + place] = fragment[i];
    to_range[child[own_child].first + place] = own_child;
  });
  order = std::move(next);
  return below;
}

template <class Executor, class Stored>
BinaryHierarchy<Executor> spatial_split_hierarchy(Executor& executor, const SceneView<Stored>& scene,
                                                  double margin, ArrayOf<Executor, BinaryNode> leaves) {
  const auto count = static_cast<std::uint32_t>(leaves.size());
  if (count == 0) return {};
  FragmentLevel<Executor> next{executor.template array<FragmentRange>(1),
                               executor.template array<BinaryNode>(1)};
  executor.for_each(1, [=, whole = next.ranges.data(), alone = next.nodes.data(),
                        leaf = leaves.data()] MASU_PASS(std::uint64_t) {
    *whole = {0, count, static_cast<std::uint32_t>(spare_fragments * count)};
    *alone = *leaf;
  });
  RangeSums all = sum_ranges(executor, next);
  FragmentOrder<Executor> order{std::move(leaves), executor.template zeros<std::uint32_t>(count)};
  std::vector<FragmentLevel<Executor>> levels;
  for (int depth = 0; next.ranges.size() > 0; ++depth) {
    levels.push_back(std::move(next));
    FragmentLevel<Executor>& level = levels.back();
    if (all.children == 0) break;
    auto splits = executor.template array<RangeSplit>(level.ranges.size());
    if (split_objects(executor, level, all, order, levels.front().nodes.data(), depth, splits) > 0) {
      over_ranges(executor, level, all.chunks,
                  SplitSpace<Stored>{scene, margin, order.fragments.data(), level.nodes.data(), splits.data(),
                                     level.ranges.data()});
      divide(executor, scene, margin, splits, level, order);
    }
    next = next_level(executor, splits, level, all.children, order, all);
  }
  // The root, one that isn't there, and the others in pairs, one level after another.
  std::uint64_t numbers = 1;
  for (const FragmentLevel<Executor>& level : levels)
    numbers += level.ranges.size();
  BinaryHierarchy<Executor> hierarchy{executor.template array<BinaryNode>(numbers),
                                      executor.template array<CollapseChoice>(numbers)};
  combine(executor, std::move(levels), hierarchy);
  return hierarchy;
}

} // namespace masu
