// The cheapest split of a range of leaves (leaf_split.h), by a group of threads (thread_group.h).
#pragma once

#include "libgrid/hierarchy/binary/leaf_split.h"
#include "libscene/passes/thread_group.h"

#include <cmath>

namespace masu {

// What a group's threads share.
struct SplitScratch {
  Boxf centres;
  struct {
    Boxf box;
    std::uint32_t count;
  } bins[3][max_bins];
};

MASU_HD inline float cost_of(const Boxf& left, std::uint32_t left_count, const Boxf& right,
                             std::uint32_t right_count) {
  return split_cost(half_area(left), static_cast<float>(left_count), half_area(right),
                    static_cast<float>(right_count));
}

// Of any of `count` leaves, leaf(i) in their order, as the last one on the left, sorted along each axis. The
// split is the first thread's, a tile's is all its threads'.
template <class ThreadGroup, class Leaf>
MASU_HD LeafSplit cheapest_split_of_few(const ThreadGroup& group, std::uint32_t count, const Leaf& leaf) {
  LeafSplit best;
  for (auto axis = static_cast<int>(group.thread_rank()); axis < 3; axis += static_cast<int>(group.size())) {
    float centres[few_leaves];
    Boxf boxes[few_leaves], right[few_leaves];
    for (std::uint32_t i = 0; i < count; ++i) {
      const BinaryNode& own = leaf(i);
      const float centre = twice_the_centre(own, axis);
      std::uint32_t to = i;
      for (; to > 0 && centre < centres[to - 1]; --to) {
        centres[to] = centres[to - 1];
        boxes[to] = boxes[to - 1];
      }
      centres[to] = centre;
      boxes[to] = own.box();
    }
    right[count - 1] = boxes[count - 1];
    for (std::uint32_t i = count - 1; i-- > 1;)
      right[i] = join(boxes[i], right[i + 1]);
    LeafSplit split;
    split.axis = axis;
    Boxf left = empty_box<float>();
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
      left = join(left, boxes[i]);
      if (centres[i] == centres[i + 1]) continue;
      split.cost = cost_of(left, i + 1, right[i + 1], count - i - 1);
      split.place = centres[i];
      if (comes_before(split, best)) best = split;
    }
  }
  return group.first_of_all(best);
}

MASU_HD inline bool comes_before(const AxisSplit& a, const AxisSplit& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.axis != b.axis ? a.axis < b.axis : a.number < b.number;
}

// What is on one side of a split.
struct SplitSide {
  Boxf box = empty_box<float>();
  std::uint32_t count = 0;

  MASU_HD void add(const Boxf& other, std::uint32_t by) {
    box = join(box, other);
    count += by;
  }
};
MASU_HD inline void add_candidate(const AxisSplit& candidate, const SplitSide& left, const SplitSide& right,
                                  AxisSplit& best) {
  if (left.count == 0 || right.count == 0) return;
  AxisSplit split = candidate;
  split.cost = cost_of(left.box, left.count, right.box, right.count);
  if (comes_before(split, best)) best = split;
}

// The cheapest split after one of so many bins along an axis, for the first thread. sides(candidate, left,
// right) adds what is on either side of it.
template <class ThreadGroup, class Act>
MASU_HD AxisSplit cheapest_after_bin(const ThreadGroup& group, std::int32_t bins, const Act& sides) {
  AxisSplit best;
  const auto own = static_cast<std::int32_t>(group.thread_rank()), // candidates are the first warp's
      threads = min(static_cast<std::int32_t>(group.size()), lanes_per_warp);
  for (std::int32_t i = own; own < threads && i < 3 * (bins - 1); i += threads) {
    const AxisSplit candidate{INFINITY, i / (bins - 1), i % (bins - 1)};
    SplitSide left, right;
    sides(candidate, left, right);
    add_candidate(candidate, left, right, best);
  }
  return group.first_of_all(best);
}

// The cheapest between bins, by a warp's threads, a bin each: of each bin all up to it, and all from it on.
template <class Tile>
MASU_HD LeafSplit cheapest_by_lanes(const Tile& tile, const LeafBins (&along)[3], const SplitScratch& scratch,
                                    std::uint32_t count) {
  const std::uint32_t bin = tile.thread_rank(), bins = static_cast<std::uint32_t>(along[0].count);
  LeafSplit best, split;
  for (split.axis = 0; split.axis < 3; ++split.axis) {
    auto left = scratch.bins[split.axis][min(bin, bins - 1)];
    if (bin >= bins) left = {empty_box<float>(), 0};
    Boxf right = left.box;
    for (std::uint32_t apart = 1; apart < max_bins; apart *= 2) {
      const auto before = tile.of_lane(left, bin - apart);
      const Boxf after = tile.of_lane(right, bin + apart);
      if (bin >= apart) left = {join(left.box, before.box), left.count + before.count};
      if (bin + apart < max_bins) right = join(right, after);
    }
    right = tile.of_lane(right, bin + 1);
    if (bin + 1 >= bins || left.count == 0 || left.count == count) continue;
    split.cost = cost_of(left.box, left.count, right, count - left.count);
    split.place = along[split.axis].end(static_cast<std::int32_t>(bin));
    if (comes_before(split, best)) best = split;
  }
  return tile.first_of_all(best);
}

// The same of more leaves. `space`: twice where they may be.
template <class ThreadGroup, class Leaf>
MASU_HD LeafSplit cheapest_split(const ThreadGroup& group, SplitScratch& scratch, std::uint32_t count,
                                 const Boxf& space, const Leaf& leaf) {
  const LeafSample sample(count);
  const auto for_each_leaf = [&](const auto& act) {
    sample.for_each(group.thread_rank(), group.size(),
                    [&](std::uint32_t i, std::uint32_t stands_for) { act(leaf(i), stands_for); });
  };
  if (group.thread_rank() == 0) scratch.centres = empty_box<float>();
  const std::int32_t bins = bin_count(count);
  for (auto i = static_cast<std::int32_t>(group.thread_rank()); i < 3 * bins;
       i += static_cast<std::int32_t>(group.size()))
    scratch.bins[i / bins][i % bins] = {empty_box<float>(), 0};
  group.sync();
  Boxf centres = empty_box<float>();
  for_each_leaf([&](const BinaryNode& own, std::uint32_t) { centres = join(centres, own.min + own.max); });
  group.join(scratch.centres, centres);
  group.sync();
  const LeafBins along[] = {{sample, scratch.centres, space, 0},
                            {sample, scratch.centres, space, 1},
                            {sample, scratch.centres, space, 2}};
  for_each_leaf([&](const BinaryNode& own, std::uint32_t stands_for) {
    for (int axis = 0; axis < 3; ++axis) {
      auto& bin = scratch.bins[axis][along[axis](twice_the_centre(own, axis))];
      group.join(bin.box, own.box());
      group.count(bin.count, stands_for);
    }
  });
  group.sync();
  if constexpr (requires { group.of_lane(scratch.centres, 0); }) {
    return cheapest_by_lanes(group, along, scratch, count);
  } else if constexpr (requires { group.template tile<max_bins>().of_lane(scratch.centres, 0); }) {
    if (group.thread_rank() >= max_bins) return {};
    return cheapest_by_lanes(group.template tile<max_bins>(), along, scratch, count);
  } else {
    const auto add = [&](const AxisSplit& split, SplitSide& left, SplitSide& right) {
      for (std::int32_t b = 0; b < bins; ++b) {
        const auto& bin = scratch.bins[split.axis][b];
        (b <= split.number ? left : right).add(bin.box, bin.count);
      }
    };
    const AxisSplit best = cheapest_after_bin(group, bins, add);
    if (best.axis < 0) return {};
    return {best.cost, best.axis, along[best.axis].end(best.number)};
  }
}

} // namespace masu
