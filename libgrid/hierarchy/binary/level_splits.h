// How a level's ranges of leaves are split that aren't small, by a block of threads each: by centres
// (leaf_split.h), or by planes that divide what is large (large_leaves.h).
#pragma once

#include "libgrid/hierarchy/binary/fragment_split_passes.h"
#include "libgrid/hierarchy/binary/large_leaves.h"
#include "libgrid/hierarchy/binary/small_ranges.h"
#include "libscene/base/fetch.h"

#include <algorithm>

namespace masu {

inline constexpr std::uint32_t no_range = ~0U; // of leaves that aren't in one any more

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
