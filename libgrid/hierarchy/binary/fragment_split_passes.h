// How a level's ranges of fragments are split (fragment_split.h), on whatever executor (executor.h).
#pragma once

#include "libgrid/hierarchy/binary/fragment_levels.h"
#include "libgrid/hierarchy/binary/fragment_split.h"
#include "libgrid/hierarchy/binary/split_ranges.h"
#include "libscene/base/atomic.h"

namespace masu {

// Writes a node's box, and that of twice the centres.
struct FindExtents {
  static constexpr unsigned threads = 8; // of a tile
  struct Sum {
    Boxf box, centres;

    // Of threads' own.
    template <class ThreadGroup>
    MASU_HD void gather(const ThreadGroup& group, const Boxf& own, const Boxf& own_centres) {
      if (group.thread_rank() == 0) box = centres = empty_box<float>();
      group.sync();
      group.join(box, own);
      group.join(centres, own_centres);
    }
    template <class ThreadGroup>
    MASU_HD void put(const ThreadGroup& group, Sum& to) const {
      if (group.thread_rank() == 0) to = *this;
    }
    template <class ThreadGroup>
    MASU_HD void join(const ThreadGroup& group, const Sum* chunks, std::uint32_t count) {
      Boxf own = empty_box<float>(), own_centres = own;
      for (std::uint32_t i = group.thread_rank(); i < count; i += group.size()) {
        own = masu::join(own, chunks[i].box);
        own_centres = masu::join(own_centres, chunks[i].centres);
      }
      gather(group, own, own_centres);
    }
  };
  const BinaryNode* fragments;
  const FragmentRange* ranges;
  BinaryNode* nodes;
  Boxf* centres;

  MASU_HD bool concerns(std::uint64_t range) const { return ranges[range].count > 1; }
  template <class ThreadGroup>
  MASU_HD void sum_up(const ThreadGroup& group, Sum& sum, std::uint64_t, std::uint32_t first,
                      std::uint32_t end) const {
    Boxf own = empty_box<float>(), own_centres = own;
    for (std::uint32_t i = first + group.thread_rank(); i < end; i += group.size()) {
      const BinaryNode fragment = fragments[i];
      own = join(own, fragment.box());
      own_centres = join(own_centres, fragment.min + fragment.max);
    }
    sum.gather(group, own, own_centres);
  }
  template <class ThreadGroup>
  MASU_HD void finish(const ThreadGroup& group, const Sum& sum, std::uint64_t range) const {
    if (group.thread_rank() != 0) return;
    nodes[range] = {sum.box.min, 0, sum.box.max, 0};
    centres[range] = sum.centres;
  }
};

// What the bins along each axis hold: the join of boxes, and how many fragments begin and end there.
template <std::int32_t most>
struct BinSums {
  struct Bin {
    Boxf box;
    std::uint32_t begin, end;
  } along[3][most];

  template <class ThreadGroup>
  MASU_HD void clear(const ThreadGroup& group, std::int32_t bins) {
    for_each(group, bins, [](Bin& bin, std::int32_t, std::int32_t) { bin = {empty_box<float>(), 0, 0}; });
    group.sync();
  }
  template <class ThreadGroup>
  MASU_HD void put(const ThreadGroup& group, BinSums& to) {
    for_each(group, most,
             [&](const Bin& bin, std::int32_t axis, std::int32_t i) { to.along[axis][i] = bin; });
  }
  template <class ThreadGroup>
  MASU_HD void join(const ThreadGroup& group, const BinSums* chunks, std::uint32_t count) {
    for_each(group, most, [&](Bin& bin, std::int32_t axis, std::int32_t i) {
      Bin sum = chunks[0].along[axis][i];
      for (std::uint32_t c = 1; c < count; ++c) {
        const Bin& other = chunks[c].along[axis][i];
        sum = {masu::join(sum.box, other.box), sum.begin + other.begin, sum.end + other.end};
      }
      bin = sum;
    });
  }
  // act(bin, axis, which along it), of the first so many along each.
  template <class ThreadGroup, class Act>
  MASU_HD void for_each(const ThreadGroup& group, std::int32_t bins, const Act& act) {
    for (auto i = static_cast<std::int32_t>(group.thread_rank()); i < 3 * bins;
         i += static_cast<std::int32_t>(group.size()))
      act(along[i / bins][i % bins], i / bins, i % bins);
  }
  // Of the first so many bins along each axis, for the first thread.
  template <class ThreadGroup>
  MASU_HD AxisSplit cheapest(const ThreadGroup& group, std::int32_t bins) const {
    return cheapest_after_bin(group, bins, [&](const AxisSplit& split, SplitSide& left, SplitSide& right) {
      for (std::int32_t b = 0; b < bins; ++b) {
        const Bin& bin = along[split.axis][b];
        b <= split.number ? left.add(bin.box, bin.begin) : right.add(bin.box, bin.end);
      }
    });
  }
};

// By centres.
struct SplitObjects {
  static constexpr unsigned threads = 16; // of a tile
  using Sum = BinSums<most_bins>;
  const BinaryNode* fragments;
  const FragmentRange* ranges;
  const Boxf* centres;
  const BinaryNode* root;
  RangeSplit* splits;
  std::uint32_t* overlapping; // ranges: counted
  std::uint64_t fewest_in_halves;

  MASU_HD bool concerns(std::uint64_t range) const { return ranges[range].count > 1; }
  template <class ThreadGroup>
  MASU_HD void sum_up(const ThreadGroup& group, Sum& sum, std::uint64_t range, std::uint32_t first,
                      std::uint32_t end) const {
    if (ranges[range].count <= few_leaves) return;
    sum.clear(group, bins_by_centre(ranges[range].count));
    const FragmentBins bins[] = {bins_along(range, 0), bins_along(range, 1), bins_along(range, 2)};
    for (std::uint32_t i = first + group.thread_rank(); i < end; i += group.size()) {
      const BinaryNode fragment = fragments[i];
      for (int axis = 0; axis < 3; ++axis) {
        auto& bin = sum.along[axis][bins[axis](twice_the_centre(fragment, axis))];
        group.join(bin.box, fragment.box());
        group.count(bin.begin);
      }
    }
  }
  template <class ThreadGroup>
  MASU_HD void finish(const ThreadGroup& group, Sum& sum, std::uint64_t range) const {
    const auto [first, count, room] = ranges[range];
    const std::int32_t bin_count = bins_by_centre(count);
    const bool is_halved = count >= fewest_in_halves, is_few = count <= few_leaves;
    AxisSplit best;
    if (is_few && !is_halved) best = cheapest_of_few(group, range);
    if (!is_few && !is_halved) {
      // Each begins and ends in a bin.
      sum.for_each(group, bin_count, [](auto& bin, std::int32_t, std::int32_t) { bin.end = bin.begin; });
      group.sync();
      best = sum.cheapest(group, bin_count);
    }
    if (group.thread_rank() != 0) return;
    RangeSplit split;
    if (best.axis >= 0) {
      split = {SplitKind::by_centre, best, bins_along(range, best.axis), false};
      Boxf left = empty_box<float>(), right = left;
      const auto add_to_side = [&](const Boxf& box, std::int32_t bin) {
        Boxf& side = bin <= best.number ? left : right;
        side = join(side, box);
      };
      for (std::uint32_t i = first; is_few && i < first + count; ++i)
        add_to_side(fragments[i].box(), split.along(twice_the_centre(fragments[i], best.axis)));
      for (std::int32_t i = 0; !is_few && i < bin_count; ++i)
        add_to_side(sum.along[best.axis][i].box, i);
      split.overlaps = room > 0 && is_worth_splitting(common(left, right), half_area(root->box()));
      if (split.overlaps) static_cast<void>(added(*overlapping, 1));
    }
    splits[range] = split;
  }

private:
  MASU_HD FragmentBins bins_along(std::uint64_t range, int axis) const {
    return {centres[range], axis, bins_by_centre(ranges[range].count)};
  }
  // After any of the bins that their centres are in.
  template <class ThreadGroup>
  MASU_HD AxisSplit cheapest_of_few(const ThreadGroup& group, std::uint64_t range) const {
    const auto [first, count, room] = ranges[range];
    AxisSplit best;
    for (std::uint32_t i = group.thread_rank(); i < 3 * count; i += group.size()) {
      const auto axis = static_cast<std::int32_t>(i % 3);
      const FragmentBins bins = bins_along(range, axis);
      const AxisSplit candidate{INFINITY, axis, bins(twice_the_centre(fragments[first + i / 3], axis))};
      SplitSide left, right;
      for (std::uint32_t k = first; k < first + count; ++k) {
        const BinaryNode fragment = fragments[k];
        (bins(twice_the_centre(fragment, axis)) <= candidate.number ? left : right).add(fragment.box(), 1);
      }
      add_candidate(candidate, left, right, best);
    }
    return group.first_of_all(best);
  }
};

// By planes at which fragments are divided, where that costs less.
template <class Stored>
struct SplitSpace {
  static constexpr unsigned threads = 32; // of a tile
  using Sum = BinSums<bins_in_space>;
  SceneView<Stored> scene;
  double margin;
  const BinaryNode* fragments;
  const BinaryNode* nodes;
  RangeSplit* splits;
  const FragmentRange* ranges;

  MASU_HD bool concerns(std::uint64_t range) const {
    return ranges[range].count > 1 && splits[range].overlaps;
  }
  template <class ThreadGroup>
  MASU_HD void sum_up(const ThreadGroup& group, Sum& sum, std::uint64_t range, std::uint32_t first,
                      std::uint32_t end) const {
    sum.clear(group, bins_in_space);
    const FragmentBins bins[] = {bins_along(range, 0), bins_along(range, 1), bins_along(range, 2)};
    for (std::uint32_t i = first + group.thread_rank(); i < end; i += group.size()) {
      const BinaryNode fragment = fragments[i];
      std::uint32_t crossed = 0; // a bit for each axis
      for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t low = bins[axis](fragment.min[axis]), high = bins[axis](fragment.max[axis]);
        group.count(sum.along[axis][low].begin);
        group.count(sum.along[axis][high].end);
        if (low == high)
          group.join(sum.along[axis][low].box, fragment.box());
        else
          crossed |= 1U << axis;
      }
      if (crossed == 0) continue;
      with_primitive(scene, fragment.index, [&](const auto& primitive) {
        for (int axis = 0; axis < 3; ++axis)
          if ((crossed >> axis & 1) != 0) cut(group, primitive, fragment.box(), axis, bins[axis], sum);
      });
    }
  }
  template <class ThreadGroup>
  MASU_HD void finish(const ThreadGroup& group, const Sum& sum, std::uint64_t range) const {
    const AxisSplit best = sum.cheapest(group, bins_in_space);
    if (group.thread_rank() == 0 && best.cost < splits[range].at.cost)
      splits[range] = {SplitKind::by_space, best, bins_along(range, best.axis), true};
  }

private:
  MASU_HD FragmentBins bins_along(std::uint64_t range, int axis) const {
    return {nodes[range].box(), axis, bins_in_space};
  }
  // Adds to each bin what lies in it.
  template <class ThreadGroup, class Primitive>
  MASU_HD void cut(const ThreadGroup& group, const Primitive& primitive, Boxf rest, int axis,
                   const FragmentBins& bins, Sum& sum) const {
    const std::int32_t last = bins(rest.max[axis]);
    for (std::int32_t bin = bins(rest.min[axis]); bin < last; ++bin) {
      const Sides sides = sides_with_margin(primitive, axis, bins.plane(bin), margin);
      const Boxf below = common(sides.below, rest);
      if (!is_empty(below)) group.join(sum.along[axis][bin].box, below);
      rest = common(sides.above, rest);
    }
    if (!is_empty(rest)) group.join(sum.along[axis][last].box, rest);
  }
};

// The splits by centres of a level's ranges, and how many are tried by planes; writes their nodes' boxes.
template <class Executor>
std::uint32_t split_objects(Executor& executor, FragmentLevel<Executor>& level, const RangeSums& all,
                            const FragmentOrder<Executor>& order, const BinaryNode* root, int depth,
                            ArrayOf<Executor, RangeSplit>& splits) {
  auto centres = executor.template array<Boxf>(level.ranges.size());
  auto overlapping = executor.template zeros<std::uint32_t>(1);
  const BinaryNode* const fragments = order.fragments.data();
  const FragmentRange* const ranges = level.ranges.data();
  over_ranges(executor, level, all.chunks,
              FindExtents{fragments, ranges, level.nodes.data(), centres.data()});
  over_ranges(executor, level, all.chunks,
              SplitObjects{fragments, ranges, centres.data(), root, splits.data(), overlapping.data(),
                           fewest_halved(depth)});
  return executor.value(overlapping, 0);
}

} // namespace masu
