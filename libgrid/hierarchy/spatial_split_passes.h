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

#include "libgrid/hierarchy/combine_passes.h"
#include "libgrid/hierarchy/fragment_split.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/hierarchy/leaf_split.h"
#include "libscene/passes/thread_group.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace masu {

// A node's fragments, so many side by side in their order, unless there is one alone. `room`: how many more
// they may become.
struct FragmentRange {
  std::uint32_t first, count, room;
};

// Ranges of more fragments are gone through in chunks, by a group of threads each.
inline constexpr std::uint32_t most_in_chunk = 4096;

// Of the ranges before one: their fragments but for those that are alone, their children, and the chunks of
// those that have several.
struct RangeSums {
  std::uint32_t fragments = 0, children = 0, chunks = 0;

  RangeSums() = default;
  MASU_HD explicit RangeSums(std::uint32_t count) {
    if (count < 2) return;
    fragments = count;
    children = 2;
    chunks = count > most_in_chunk ? (count + most_in_chunk - 1) / most_in_chunk : 0;
  }
  MASU_HD friend RangeSums operator+(RangeSums a, const RangeSums& b) {
    a.fragments += b.fragments;
    a.children += b.children;
    a.chunks += b.chunks;
    return a;
  }
};

// What is known of a level's nodes before those below are made.
struct DividedNodes {
  const FragmentRange* ranges;
  const BinaryNode* nodes;
  const RangeSums* before;

  MASU_HD bool is_leaf(std::uint64_t i) const { return ranges[i].count == 1; }
  MASU_HD const BinaryNode& leaf(std::uint64_t i) const { return nodes[i]; }
  MASU_HD std::uint32_t first_child(std::uint64_t i) const { return before[i].children; }
  // Around fragments before they were divided.
  MASU_HD Boxf box(std::uint64_t i, const BinaryNode&, const BinaryNode&) const { return nodes[i].box(); }
};

// Nodes of one depth. The children of the first are the first two of the next level, and so on.
template <class Executor>
struct FragmentLevel {
  ArrayOf<Executor, FragmentRange> ranges{};
  ArrayOf<Executor, BinaryNode> nodes{}; // a fragment that is alone; of others the box
  ArrayOf<Executor, RangeSums> before{}; // each range, and all

  DividedNodes split_nodes() const { return {ranges.data(), nodes.data(), before.data()}; }
};

// Fragments sorted by their ranges in a level, but for those that are alone. Each is a leaf of the hierarchy
// that may be divided.
template <class Executor>
struct FragmentOrder {
  ArrayOf<Executor, BinaryNode> fragments{};
  ArrayOf<Executor, std::uint32_t> ranges{};

  FragmentOrder(const Executor& executor, std::uint64_t count)
      : fragments(executor.template array<BinaryNode>(count)),
        ranges(executor.template array<std::uint32_t>(count)) {}
};

// Passes over ranges. `Work` sums up a range's fragments and acts on the sum:
//
//   concerns(range)                     whether there is anything to do
//   sum_up(group, sum, range, first, end)  of those of its fragments
//   finish(group, sum, range)
//   Sum: put(group, to), join(group, of chunks, how many)
template <class Work>
struct SumRanges {
  using Scratch = typename Work::Sum;
  Work work;
  const FragmentRange* ranges;
  const RangeSums* before;
  std::uint64_t range_count;
  Scratch* chunk_sums;

  // First ranges of one chunk, then the chunks of others.
  MASU_HD std::uint64_t size(std::uint64_t i) const {
    if (i >= range_count) return work.concerns(owner(i)) ? std::uint64_t{most_in_chunk} : 0;
    return ranges[i].count <= most_in_chunk && work.concerns(i) ? ranges[i].count : 0;
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& sum, std::uint64_t i) const {
    if (size(i) == 0) return;
    const std::uint64_t own = owner(i), chunk = i - range_count;
    const bool is_whole = i < range_count;
    const auto [first, count, room] = ranges[own];
    const std::uint32_t begin =
        is_whole ? 0 : static_cast<std::uint32_t>(chunk - before[own].chunks) * most_in_chunk;
    work.sum_up(group, sum, own, first + begin, first + std::min(count, begin + most_in_chunk));
    group.sync();
    if (is_whole)
      work.finish(group, sum, own);
    else
      sum.put(group, chunk_sums[chunk]);
  }

private:
  MASU_HD std::uint64_t owner(std::uint64_t i) const {
    if (i < range_count) return i;
    return last_not_above(range_count, i - range_count,
                          [this](std::uint64_t range) { return before[range].chunks; });
  }
};

template <class Work>
struct JoinChunks {
  using Scratch = typename Work::Sum;
  Work work;
  const RangeSums* before;
  std::uint64_t range_count;
  const Scratch* chunk_sums;

  // Of a range's first chunk.
  MASU_HD std::uint64_t size(std::uint64_t chunk) const {
    const std::uint64_t own = owner(chunk);
    return before[own].chunks == chunk && work.concerns(own) ? std::uint64_t{most_in_chunk} : 0;
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& sum, std::uint64_t chunk) const {
    if (size(chunk) == 0) return;
    const std::uint64_t own = owner(chunk);
    sum.join(group, chunk_sums + chunk, before[own + 1].chunks - before[own].chunks);
    group.sync();
    work.finish(group, sum, own);
  }

private:
  MASU_HD std::uint64_t owner(std::uint64_t chunk) const {
    return last_not_above(range_count, chunk, [this](std::uint64_t range) { return before[range].chunks; });
  }
};

// `chunks`: those of all ranges that have several.
template <class Executor, class Work>
void over_ranges(Executor& executor, const FragmentLevel<Executor>& level, std::uint64_t chunks,
                 const Work& work) {
  auto sums = executor.template array<typename Work::Sum>(chunks);
  const std::uint64_t range_count = level.ranges.size();
  const RangeSums* const before = level.before.data();
  executor.for_each_by_group(range_count + chunks,
                             SumRanges<Work>{work, level.ranges.data(), before, range_count, sums.data()});
  executor.for_each_by_group(chunks, JoinChunks<Work>{work, before, range_count, sums.data()});
}

// Writes a node's box, and that of twice the centres.
struct FindExtents {
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

// Between two bins along an axis.
struct BinSplit {
  float cost = INFINITY;
  std::int32_t axis = -1; // none: everything is in one place
  std::int32_t bin = 0;   // the last one that goes left
};
MASU_HD inline bool comes_before(const BinSplit& a, const BinSplit& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.axis != b.axis ? a.axis < b.axis : a.bin < b.bin;
}

// Fragments on one side of a split.
struct SplitSide {
  Boxf box = empty_box<float>();
  std::uint32_t count = 0;

  MASU_HD void add(const Boxf& other, std::uint32_t by) {
    box = join(box, other);
    count += by;
  }
};
MASU_HD inline void add_candidate(const BinSplit& candidate, const SplitSide& left, const SplitSide& right,
                                  BinSplit& best) {
  if (left.count == 0 || right.count == 0) return;
  BinSplit split = candidate;
  split.cost = split_cost(half_area(left.box), static_cast<float>(left.count), half_area(right.box),
                          static_cast<float>(right.count));
  if (comes_before(split, best)) best = split;
}

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
  MASU_HD BinSplit cheapest(const ThreadGroup& group, std::int32_t bins) const {
    BinSplit best;
    const auto own = static_cast<std::int32_t>(group.thread_rank()), // candidates are the first warp's
        threads = min(static_cast<std::int32_t>(group.size()), lanes_per_warp);
    for (std::int32_t i = own; own < threads && i < 3 * (bins - 1); i += threads) {
      const BinSplit candidate{INFINITY, i / (bins - 1), i % (bins - 1)};
      SplitSide left, right;
      for (std::int32_t b = 0; b < bins; ++b) {
        const Bin& bin = along[candidate.axis][b];
        b <= candidate.bin ? left.add(bin.box, bin.begin) : right.add(bin.box, bin.end);
      }
      add_candidate(candidate, left, right, best);
    }
    return group.first_of_all(best);
  }
};

enum class SplitKind : std::uint32_t { halves, by_centre, by_space };

// How a range is split.
struct RangeSplit {
  SplitKind kind = SplitKind::halves;
  BinSplit at{};
  FragmentBins along{};
  bool overlaps = false; // by so much that planes are tried

  MASU_HD bool is_left(const BinaryNode& fragment) const {
    if (kind == SplitKind::halves) return false;
    const float centre = twice_the_centre(fragment, at.axis);
    return kind == SplitKind::by_space ? centre < 2 * along.plane(at.bin) : along(centre) <= at.bin;
  }
  // By the plane; then its parts, unless one is empty.
  template <class Stored>
  MASU_HD bool divides(const SceneView<Stored>& scene, double margin, const BinaryNode& fragment,
                       Sides& parts) const {
    if (kind != SplitKind::by_space || along(fragment.min[at.axis]) > at.bin ||
        along(fragment.max[at.axis]) <= at.bin)
      return false;
    with_primitive(scene, fragment.index, [&](const auto& primitive) {
      parts = sides_with_margin(primitive, at.axis, along.plane(at.bin), margin);
    });
    parts = {common(parts.below, fragment.box()), common(parts.above, fragment.box())};
    return !is_empty(parts.below) && !is_empty(parts.above);
  }
};

// By centres.
struct SplitObjects {
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
    BinSplit best;
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
        Boxf& side = bin <= best.bin ? left : right;
        side = join(side, box);
      };
      for (std::uint32_t i = first; is_few && i < first + count; ++i)
        add_to_side(fragments[i].box(), split.along(twice_the_centre(fragments[i], best.axis)));
      for (std::int32_t i = 0; !is_few && i < bin_count; ++i)
        add_to_side(sum.along[best.axis][i].box, i);
      const Boxf overlap = common(left, right);
      split.overlaps = room > 0 && !is_empty(overlap) &&
                       half_area(overlap) > overlap_worth_splitting * half_area(root->box());
      if (split.overlaps) static_cast<void>(added(*overlapping, 1));
    }
    splits[range] = split;
  }

private:
  MASU_HD FragmentBins bins_along(std::uint64_t range, int axis) const {
    return {centres[range].min[axis], centres[range].max[axis], bins_by_centre(ranges[range].count)};
  }
  // After any of the bins that their centres are in.
  template <class ThreadGroup>
  MASU_HD BinSplit cheapest_of_few(const ThreadGroup& group, std::uint64_t range) const {
    const auto [first, count, room] = ranges[range];
    BinSplit best;
    for (std::uint32_t i = group.thread_rank(); i < 3 * count; i += group.size()) {
      const auto axis = static_cast<std::int32_t>(i % 3);
      const FragmentBins bins = bins_along(range, axis);
      const BinSplit candidate{INFINITY, axis, bins(twice_the_centre(fragments[first + i / 3], axis))};
      SplitSide left, right;
      for (std::uint32_t k = first; k < first + count; ++k) {
        const BinaryNode fragment = fragments[k];
        (bins(twice_the_centre(fragment, axis)) <= candidate.bin ? left : right).add(fragment.box(), 1);
      }
      add_candidate(candidate, left, right, best);
    }
    return group.first_of_all(best);
  }
};

// By planes at which fragments are divided, where that costs less.
template <class Stored>
struct SplitSpace {
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
    const BinSplit best = sum.cheapest(group, bins_in_space);
    if (group.thread_rank() == 0 && best.cost < splits[range].at.cost)
      splits[range] = {SplitKind::by_space, best, bins_along(range, best.axis), true};
  }

private:
  MASU_HD FragmentBins bins_along(std::uint64_t range, int axis) const {
    return {nodes[range].min[axis], nodes[range].max[axis], bins_in_space};
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
    Sides parts;
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
  FragmentOrder<Executor> divided(executor, count + all_added);
  BinaryNode* const to = divided.fragments.data();
  std::uint32_t* const to_range = divided.ranges.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    const auto [first, in_range, room] = range[own];
    const std::uint64_t at = i + added_before[own];
    const std::uint32_t before = crossing_before[i] - crossing_before[first];
    BinaryNode whole = fragment[i];
    to_range[at] = own;
    Sides parts;
    if (crossing_before[i + 1] != crossing_before[i] && before < room &&
        split[own].divides(scene, margin, whole, parts)) {
      const std::uint64_t above = std::uint64_t{first} + added_before[own] + in_range + before;
      to[above] = {parts.above.min, whole.index, parts.above.max, 1};
      to_range[above] = own;
      whole = {parts.below.min, whole.index, parts.below.max, 1};
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
// on.
struct Partition {
  const std::uint32_t* left_before; // each of the range's fragments, and all
  std::uint32_t count, left;

  MASU_HD std::uint32_t lefts(std::uint64_t i) const { return left_before[i] - left_before[0]; }
  MASU_HD std::uint32_t place_of(std::uint32_t i) const {
    const bool is_left = left_before[i + 1] != left_before[i];
    if (is_left == (i < left)) return i;
    if (is_left)
      return static_cast<std::uint32_t>(last_not_above(left, left - 1 - lefts(i), [this](std::uint64_t k) {
        return static_cast<std::uint32_t>(k) - lefts(k);
      }));
    return static_cast<std::uint32_t>(
        last_not_above(count, left - 1 - (i - lefts(i)), [this](std::uint64_t k) { return lefts(k); }));
  }
};

// Sums over a level's ranges, and those of all.
template <class Executor>
RangeSums sum_ranges(Executor& executor, FragmentLevel<Executor>& level) {
  const std::uint64_t count = level.ranges.size();
  level.before = executor.template array<RangeSums>(count + 1);
  RangeSums* const sum = level.before.data();
  const FragmentRange* const range = level.ranges.data();
  executor.for_each(count + 1, [=] MASU_PASS(std::uint64_t i) {
    sum[i] = i != count ? RangeSums(range[i].count) : RangeSums();
  });
  executor.scan(level.before);
  return executor.value(level.before, count);
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
  BinaryNode* const alone = below.nodes.data();
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
  const RangeSums* const child_before = below.before.data();
  executor.for_each(child_count,
                    [=] MASU_PASS(std::uint64_t i) { child[i].first = child_before[i].fragments; });
  FragmentOrder<Executor> next(executor, all.fragments);
  BinaryNode* const to = next.fragments.data();
  std::uint32_t* const to_range = next.ranges.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = range_of[i];
    const auto [first, in_range, room] = range[own];
    std::uint32_t own_child = before[own].children, place = static_cast<std::uint32_t>(i) - first;
    const std::uint32_t left = child[own_child].count;
    if (split[own].kind != SplitKind::halves)
      place = Partition{left_before + first, in_range, left}.place_of(place);
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
  FragmentRange* const whole = next.ranges.data();
  BinaryNode* const alone = next.nodes.data();
  const BinaryNode* const leaf = leaves.data();
  executor.for_each(1, [=] MASU_PASS(std::uint64_t) {
    *whole = {0, count, static_cast<std::uint32_t>(spare_fragments * count)};
    *alone = *leaf;
  });
  RangeSums all = sum_ranges(executor, next);
  FragmentOrder<Executor> order(executor, 0);
  order.fragments = std::move(leaves);
  order.ranges = executor.template zeros<std::uint32_t>(count);
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
  return combined(executor, std::move(levels));
}

} // namespace masu
