// How a level's ranges of leaves are split that aren't small, by a block of threads each: by centres
// (leaf_split.h), or by planes that divide what is large (large_leaves.h); and what is made of them.
#pragma once

#include "libgrid/hierarchy/binary/fragment_split_passes.h"
#include "libgrid/hierarchy/binary/large_leaves.h"
#include "libgrid/hierarchy/binary/small_ranges.h"
#include "libscene/base/fetch.h"

#include <algorithm>

namespace masu {

inline constexpr std::uint32_t no_range = ~0U; // of leaves that aren't in one any more

// Numbers ranges as they are made, in any order: nothing depends on it.
struct RangeNumbers {
  SmallRange* small;     // the small ones of all levels,
  std::uint32_t* counts; // and how many they are; then of each depth how many ranges,
  std::uint32_t* most;   // and of how many leaves at most

  MASU_HD static std::uint32_t place(std::uint32_t depth) { return 1 + depth; }
  // Of a range of that depth; two of the next one where it is large.
  MASU_HD LeafRange numbered(std::uint32_t first, std::uint32_t count, std::uint32_t room, bool is_right,
                             std::uint32_t depth) const {
    LeafRange range{first, count, room, is_right ? 1U : 0U, 0};
    if (range.is_small()) {
      range.number_there = added(counts[0], 1);
      small[range.number_there] = {first, count, room, range.is_right, depth};
    } else {
      range.number_there = added(counts[place(depth + 1)], 2);
      raise(most[depth], count);
    }
    return range;
  }
};

// What a level's ranges are made into: pairs of the next one's.
struct RangesBelow {
  LeafRange* ranges;
  Boxf* spaces;         // in which twice the centres of their leaves are
  std::uint32_t* pairs; // of each range of the level: the number of its left child
  RangeNumbers numbers;
  std::uint32_t depth; // theirs

  // Of range i, of whose leaves so many go left. Where that is all or none, the split becomes none.
  MASU_HD void put(std::uint64_t i, const LeafRange& range, std::uint32_t left, const Boxf& space,
                   LeafSplit& split) const {
    if (left == 0 || left == range.count) {
      split.axis = -1;
      left = range.count / 2;
    }
    const std::uint32_t left_room = room_of_left(range.room, left, range.count),
                        right = range.first + left + left_room, at = range.number_there;
    pairs[i] = 2 * right;
    ranges[at] = numbers.numbered(range.first, left, left_room, false, depth);
    ranges[at + 1] = numbers.numbered(right, range.count - left, range.room - left_room, true, depth);
    const SplitSpaces halves(space, split);
    spaces[at] = halves.left;
    spaces[at + 1] = halves.right;
  }
};

// Ranges that aren't small.
struct SplitRanges {
  static constexpr unsigned threads = 512; // a block's
  using Scratch = SplitScratch;
  const BinaryNode* leaves;
  const std::uint32_t* order; // of leaves
  const LeafRange* ranges;
  LevelCount count;
  const Boxf* spaces;
  LeafSplit* splits;
  std::uint32_t most; // a range of more is halved, lest the hierarchy become too deep

  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    if (i >= count() || ranges[i].is_small()) return;
    const LeafRange range = ranges[i];
    const auto leaf = [&](std::uint32_t k) { return fetched(leaves + order[range.first + k]); };
    LeafSplit best;
    if (range.count <= most) best = cheapest_split(group, scratch, range.count, spaces[i], leaf);
    if (group.thread_rank() == 0) splits[i] = best;
  }
};

// Ranges of so many leaves at most are split and sorted by a block each, in one kernel: passes over the
// leaves of all ranges are seven.
inline constexpr std::uint32_t most_sorted_by_block = 1 << 15;

// Ranges that aren't small, with no room for more leaves, are split, and their leaves sorted in their places.
struct SortRanges {
  static constexpr unsigned threads = SplitRanges::threads;
  using Scratch = SplitScratch;
  SplitRanges ranges;
  std::uint32_t* order;  // what `ranges` has
  std::uint32_t* rights; // leaves that go right, until all are known
  RangesBelow below;

  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    if (i >= ranges.count() || ranges.ranges[i].is_small()) return;
    ranges(group, scratch, i);
    group.sync();
    const LeafRange range = ranges.ranges[i];
    LeafSplit split = ranges.splits[i];
    const std::uint32_t left = sort(group, range, split);
    if (group.thread_rank() == 0) below.put(i, range, left, ranges.spaces[i], split);
  }

private:
  // Those on the left first, both in their order. Returns how many are on the left.
  template <class ThreadGroup>
  MASU_HD std::uint32_t sort(const ThreadGroup& group, const LeafRange& range, const LeafSplit& split) const {
    constexpr std::uint32_t each = 8; // a thread's, which are on their way at once
    const auto warp = group.template tile<32>();
    const std::uint32_t lane = warp.thread_rank(), own_warp = group.thread_rank() / warp.size();
    std::uint32_t *const leaf = order + range.first, *const right = rights + range.first;
    std::uint32_t left = 0;
    for (std::uint32_t piece = 0; piece < range.count; piece += each * group.size()) {
      const std::uint32_t first = piece + own_warp * each * warp.size() + lane; // and every size of a warp
      std::uint32_t own[each], lefts[each], all_lefts = 0;
      for (std::uint32_t k = 0; k < each; ++k) {
        const std::uint32_t at = first + k * warp.size();
        own[k] = at < range.count ? leaf[at] : 0;
      }
      for (std::uint32_t k = 0; k < each; ++k) {
        const bool is_one = first + k * warp.size() < range.count;
        lefts[k] = warp.ballot(is_one && split.is_left(ranges.leaves[own[k]]));
        all_lefts += count_bits(lefts[k]);
      }
      std::uint32_t in_piece = 0, left_before = left + group.sum_of_warps_before(all_lefts, in_piece);
      for (std::uint32_t k = 0; k < each; ++k) {
        const std::uint32_t at = first + k * warp.size(),
                            to_left = left_before + count_bits(lefts[k] & ((1U << lane) - 1));
        if (at < range.count) ((lefts[k] >> lane & 1) != 0 ? leaf[to_left] : right[at - to_left]) = own[k];
        left_before += count_bits(lefts[k]);
      }
      left += in_piece;
    }
    group.sync();
    if (left > 0) // else all are where they were
      for (std::uint32_t k = group.thread_rank(); k < range.count - left; k += group.size())
        leaf[left + k] = right[k];
    return left;
  }
};

// A scene's triangles, of one of both stores.
struct TrianglesOfEither {
  const Triangle<float>* floats = nullptr;
  const Triangle<double>* doubles = nullptr;

  MASU_HD Triangle<double> operator()(PrimitiveIndex index) const {
    return floats != nullptr ? widened(floats[index]) : doubles[index];
  }
};
inline TrianglesOfEither triangles_of(const SceneView<float>& scene) {
  return {scene.triangles, nullptr};
}
inline TrianglesOfEither triangles_of(const SceneView<double>& scene) {
  return {nullptr, scene.triangles};
}

// What a group's threads share of leaves in the bins along each axis: those that aren't large by their
// centres, and the others where they begin and where they end.
struct PlaneScratch {
  Boxf box;
  struct {
    Boxf whole, from, to;
    std::uint32_t begin, end;
  } bins[3][bins_in_space];

  // The cheapest plane after a bin, up to which parts reach, for the first thread.
  template <class ThreadGroup>
  MASU_HD AxisSplit cheapest(const ThreadGroup& group, const FragmentBins (&along)[3]) const {
    return cheapest_after_bin(group, bins_in_space,
                              [&](const AxisSplit& split, SplitSide& left, SplitSide& right) {
                                const int axis = split.axis;
                                Boxf below = empty_box<float>(), above = below;
                                for (std::int32_t b = 0; b < bins_in_space; ++b) {
                                  const auto& bin = bins[axis][b];
                                  if (b <= split.number) {
                                    left.add(bin.whole, bin.begin);
                                    below = join(below, bin.from);
                                  } else {
                                    right.add(bin.whole, bin.end);
                                    above = join(above, bin.to);
                                  }
                                }
                                const float plane = along[axis].plane(split.number);
                                below.max.set(axis, std::min(below.max[axis], plane));
                                above.min.set(axis, std::max(above.min[axis], plane));
                                left.add(below, 0);
                                right.add(above, 0);
                              });
  }
};

// Then by planes that divide what is large, where that is cheaper.
struct SplitAtPlanes {
  static constexpr unsigned threads = 256; // a block's
  using Scratch = PlaneScratch;
  SplitRanges ranges;
  LargeLeaves large;
  TrianglesOfEither triangle;
  std::uint32_t* at_plane; // of each range: whether it is

  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& scratch, std::uint64_t i) const {
    if (i >= ranges.count()) return;
    if (group.thread_rank() == 0) at_plane[i] = 0;
    const LeafRange range = ranges.ranges[i];
    if (range.count <= most_undivided || range.room == 0 || range.count > ranges.most) return;
    const LeafSample sample(range.count);
    const auto for_each_leaf = [&](const auto& act) {
      sample.for_each(group.thread_rank(), group.size(), [&](std::uint32_t k, std::uint32_t stands_for) {
        act(fetched(ranges.leaves + ranges.order[range.first + k]), stands_for);
      });
    };
    if (group.thread_rank() == 0) scratch.box = empty_box<float>();
    for (std::uint32_t b = group.thread_rank(); b < 3 * bins_in_space; b += group.size())
      scratch.bins[b / bins_in_space][b % bins_in_space] = {empty_box<float>(), empty_box<float>(),
                                                            empty_box<float>(), 0, 0};
    group.sync();
    Boxf box = empty_box<float>();
    for_each_leaf([&](const BinaryNode& leaf, std::uint32_t) { box = join(box, leaf.box()); });
    group.join(scratch.box, box);
    group.sync();
    const FragmentBins along[] = {
        {scratch.box, 0, bins_in_space}, {scratch.box, 1, bins_in_space}, {scratch.box, 2, bins_in_space}};
    for_each_leaf([&](const BinaryNode& leaf, std::uint32_t stands_for) {
      const bool is_large = large.has(leaf);
      for (int axis = 0; axis < 3; ++axis) {
        const float centre = 0.5F * twice_the_centre(leaf, axis);
        auto& first = scratch.bins[axis][along[axis](is_large ? leaf.min[axis] : centre)];
        auto& last = is_large ? scratch.bins[axis][along[axis](leaf.max[axis])] : first;
        group.count(first.begin, stands_for);
        group.count(last.end, stands_for);
        group.join(is_large ? first.from : first.whole, leaf.box());
        if (is_large) group.join(last.to, leaf.box());
      }
    });
    group.sync();
    const AxisSplit best = scratch.cheapest(group, along);
    if (group.thread_rank() != 0 || !(best.cost < most_of_cost * ranges.splits[i].cost)) return;
    ranges.splits[i] = {best.cost, best.axis, 2 * along[best.axis].plane(best.number)};
    at_plane[i] = 1;
  }

  // Whether the leaf at a place in the order is divided, in the range that it is in; then its parts.
  MASU_HD bool divides(std::uint64_t place, std::uint32_t range, Sides& parts) const {
    return range != no_range && at_plane[range] != 0 &&
           large.divides(ranges.splits[range], ranges.leaves[ranges.order[place]], triangle, parts);
  }
};

} // namespace masu
