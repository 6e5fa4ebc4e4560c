// Splitting boxes of voxels into cells, level by level: each pass does something to all boxes of a level, or
// to all their fragments.
#pragma once

#include "libgrid/grid/merge.h"
#include "libgrid/grid/splitter.h"
#include "libgrid/grid/uniform_passes.h"
#include "libscene/base/atomic.h"
#include "libscene/passes/executor.h"

#include <atomic>
#include <optional>
#include <vector>

namespace masu {

inline constexpr std::uint32_t no_child = 0xffffffffU;

// A box of a level. While it is open, `begin` … `end` - 1 are its fragments; in the end they are a leaf's
// references among its level's.
struct LevelBox {
  VoxelBox box;
  std::uint32_t begin, end;
  std::int32_t axis, position; // the plane that divides it
  std::uint32_t child;         // index on the next level of what is below the plane; what is above follows
};
MASU_HD inline LevelBox open_box(const VoxelBox& box, std::uint32_t begin, std::uint32_t end) {
  return {box, begin, end, 0, 0, no_child};
}

template <class Executor>
struct SplitLevel {
  ArrayOf<Executor, LevelBox> boxes{};
  ArrayOf<Executor, PrimitiveIndex> listed{}; // leaf by leaf
};

// Of the fragments before one: how many there are of below a plane and above it; how many leaves list.
struct FragmentCounts {
  std::uint32_t below, above, listed;
  friend MASU_HD FragmentCounts operator+(const FragmentCounts& a, const FragmentCounts& b) {
    return {a.below + b.below, a.above + b.above, a.listed + b.listed};
  }
};

// Decides by its primitive where a fragment goes that a plane cuts, or whether a leaf lists it. What is on
// both sides stays in its place as what is below, and is in `above` as what is above.
template <class Stored>
struct DecideFragment {
  Splitter<Stored> splitter;
  const LevelBox* boxes;
  Fragment *fragments, *above;
  FragmentCounts* counts;

  MASU_HD void operator()(std::uint32_t i, std::uint32_t box) const {
    const LevelBox& own = boxes[box];
    if (own.child == no_child) {
      counts[i] = {0, 0, splitter.lists(own.box, fragments[i].primitive)};
      return;
    }
    Fragment low{}, high{};
    const auto sides = splitter.cut(fragments[i], Plane{own.axis, own.position}, low, high);
    counts[i] = {sides.below, sides.above, 0};
    fragments[i] = sides.below ? low : high;
    if (sides.below && sides.above) above[i] = high;
  }
};

// Fragments to be decided by a pass of their own, so that all threads of a warp have a primitive to test:
// those that a plane cuts from the list's front on, those in leaves from its back.
struct Undecided {
  std::uint32_t fragment, box;
};
struct UndecidedCounts {
  std::uint32_t cut, in_leaves;
};

// Chooses the boxes' planes, and counts the fragments on either side of them.
template <class Executor, class Stored>
struct DivideBoxes {
  using Scratch = PlaneBins;
  DecideFragment<Stored> decide;
  LevelBox* boxes;
  Undecided *undecided, *undecided_end;
  UndecidedCounts* lengths;

  MASU_HD std::uint32_t size(std::uint64_t i) const { return boxes[i].end - boxes[i].begin; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, PlaneBins& bins, std::uint64_t i) const {
    LevelBox& own = boxes[i];
    const Fragment* const fragments = decide.fragments;
    const Plane best = decide.splitter.best_plane(group, bins, own.box, fragments + own.begin, size(i));
    if (group.thread_rank() == 0) {
      own.axis = best.axis;
      own.position = best.position;
      own.child = is_plane(best) ? 0 : no_child;
    }
    group.sync();
    const std::int32_t axis = own.axis, position = own.position;
    const bool is_leaf = own.child == no_child;
    const auto box = static_cast<std::uint32_t>(i);
    const std::uint32_t end = own.end;
    for (std::uint32_t f = own.begin + group.thread_rank(); f < end; f += group.size()) {
      const std::uint32_t below = fragments[f].first[axis] < position,
                          above = fragments[f].last[axis] >= position;
      if (!is_leaf && below + above == 1) {
        decide.counts[f] = {below, above, 0};
      } else if (!Executor::has_warps) {
        decide(f, box);
      } else if (is_leaf) {
        *(undecided_end - 1 - added(lengths->in_leaves, 1)) = {f, box};
      } else {
        undecided[added(lengths->cut, 1)] = {f, box};
      }
    }
  }
};

// The next level's boxes and fragments: of each divided box those below, then those above, in their order.
// What leaves list goes to `listed`.
struct MoveFragments {
  using Scratch = NoScratch;
  LevelBox* boxes;
  const Fragment *fragments, *above;
  const FragmentCounts* before;
  const std::uint32_t* divided_before; // of the boxes
  LevelBox* next_boxes;
  Fragment* next_fragments;
  PrimitiveIndex* listed;

  MASU_HD std::uint32_t size(std::uint64_t i) const { return boxes[i].end - boxes[i].begin; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    const LevelBox own = boxes[i];
    const FragmentCounts first = before[own.begin], last = before[own.end];
    const std::uint32_t begin = first.below + first.above, middle = begin + last.below - first.below;
    for (std::uint32_t f = own.begin + group.thread_rank(); f < own.end; f += group.size()) {
      const FragmentCounts here = before[f], after = before[f + 1];
      if (own.child == no_child) {
        if (after.listed != here.listed) listed[here.listed] = fragments[f].primitive;
        continue;
      }
      const bool is_below = after.below != here.below, is_above = after.above != here.above;
      if (is_below) next_fragments[begin + here.below - first.below] = fragments[f];
      if (is_above) next_fragments[middle + here.above - first.above] = is_below ? above[f] : fragments[f];
    }
    group.sync(); // all have read the box
    if (group.thread_rank() != 0) return;
    if (own.child == no_child) {
      boxes[i].begin = first.listed;
      boxes[i].end = last.listed;
      return;
    }
    const std::uint32_t child = boxes[i].child = 2 * divided_before[i];
    LevelBox low = open_box(own.box, begin, middle),
             high = open_box(own.box, middle, last.below + last.above);
    low.box.end.set(own.axis, own.position);
    high.box.first.set(own.axis, own.position);
    next_boxes[child] = low;
    next_boxes[child + 1] = high;
  }
};

// Divides the level's boxes, once or not at all, and returns the next level's, if there aren't too many
// fragments. `fragments` are those of the level, and afterwards those of the next.
template <class Executor, class Stored>
std::optional<SplitLevel<Executor>> split_level(Executor& executor, const Splitter<Stored>& splitter,
                                                SplitLevel<Executor>& level,
                                                ArrayOf<Executor, Fragment>& fragments) {
  const std::uint64_t box_count = level.boxes.size(), count = fragments.size();
  auto counts = executor.template array<FragmentCounts>(count + 1);
  auto fragments_above = executor.template array<Fragment>(count);
  auto list = executor.template array<Undecided>(Executor::has_warps ? count : 0);
  auto list_lengths = executor.template zeros<UndecidedCounts>(1);
  LevelBox* const boxes = level.boxes.data();
  Fragment *const fragment = fragments.data(), *const above = fragments_above.data();
  FragmentCounts* const before = counts.data();
  Undecided* const undecided = list.data();
  UndecidedCounts* const lengths = list_lengths.data();
  const DecideFragment<Stored> decide{splitter, boxes, fragment, above, before};
  executor.for_each_by_group(
      box_count, DivideBoxes<Executor, Stored>{decide, boxes, undecided, undecided + list.size(), lengths});
  const auto divided =
      sums_before(executor, box_count, [=] MASU_PASS(std::uint64_t i) { return boxes[i].child != no_child; });
  executor.for_each(list.size(), [=] MASU_PASS(std::uint64_t i) {
    if (i < lengths->cut || i >= count - lengths->in_leaves) decide(undecided[i].fragment, undecided[i].box);
  });
  executor.for_each(1, [=] MASU_PASS(std::uint64_t i) { before[count + i] = {0, 0, 0}; });
  executor.scan(counts);
  const FragmentCounts all = executor.value(counts, count);
  const std::uint64_t next_count = std::uint64_t{all.below} + all.above;
  if (next_count > max_numbered) return std::nullopt;
  level.listed = executor.template array<PrimitiveIndex>(all.listed);
  auto next_fragments = executor.template array<Fragment>(next_count);
  SplitLevel<Executor> next{
      executor.template array<LevelBox>(2 * std::uint64_t{executor.value(divided, box_count)}), {}};
  executor.for_each_by_group(box_count,
                             MoveFragments{boxes, fragment, above, before, divided.data(), next.boxes.data(),
                                           next_fragments.data(), level.listed.data()});
  fragments = std::move(next_fragments);
  return next;
}

// How many fragments there have been on all levels of a grid's parts, which several threads may build. Lists
// that hardly get shorter where they are divided make more and more of them: a bound on the sum holds for the
// grid's time and memory, and is exceeded or not in whatever order parts are built.
using FragmentSum = std::atomic<std::uint64_t>;

// All levels, from the one given down; the last has no boxes. None where there are too many fragments.
template <class Executor, class Stored>
std::vector<SplitLevel<Executor>> split_all(Executor& executor, const Splitter<Stored>& splitter,
                                            SplitLevel<Executor> first, ArrayOf<Executor, Fragment> fragments,
                                            FragmentSum& sum) {
  std::vector<SplitLevel<Executor>> levels;
  levels.push_back(std::move(first));
  while (levels.back().boxes.size() > 0) {
    if ((sum += fragments.size()) > splitter.options.max_fragments) return {};
    auto next = split_level(executor, splitter, levels.back(), fragments);
    if (!next) return {};
    levels.push_back(std::move(*next));
  }
  return levels;
}

// What exceeds where there are more leaves, or references of them, than can be numbered.
template <class Executor>
const char* exceeded_by_leaves(const std::vector<SplitLevel<Executor>>& levels) {
  if (levels.empty()) return too_many_fragments;
  std::uint64_t leaves = 0, references = 0;
  for (const SplitLevel<Executor>& level : levels) {
    leaves += level.boxes.size();
    references += level.listed.size();
  }
  // All boxes but the first are halves of others.
  leaves -= (leaves - levels.front().boxes.size()) / 2;
  return exceeded_by_sizes(leaves, references, 0, 0);
}

// Leaves, and what they list, of a box; or before it, in the order in which a box is divided: below, then
// above.
struct LeafCounts {
  std::uint32_t leaves, references;
  friend MASU_HD LeafCounts operator+(const LeafCounts& a, const LeafCounts& b) {
    return {a.leaves + b.leaves, a.references + b.references};
  }
};

// Of every level's boxes.
template <class Executor>
std::vector<ArrayOf<Executor, LeafCounts>> count_leaves(Executor& executor,
                                                        const std::vector<SplitLevel<Executor>>& levels) {
  std::vector<ArrayOf<Executor, LeafCounts>> counts(levels.size());
  for (std::size_t level = levels.size(); level-- > 0;) {
    const std::uint64_t count = levels[level].boxes.size();
    counts[level] = executor.template array<LeafCounts>(count);
    const LevelBox* const boxes = levels[level].boxes.data();
    LeafCounts* const own = counts[level].data();
    const LeafCounts* const below = level + 1 < levels.size() ? counts[level + 1].data() : nullptr;
    executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
      const LevelBox& box = boxes[i];
      own[i] = box.child == no_child ? LeafCounts{1, box.end - box.begin}
                                     : below[box.child] + below[box.child + 1];
    });
  }
  return counts;
}

// Writes the leaves of a level as cells, and what they list; and says where those of the next level begin.
struct WriteLeaves {
  using Scratch = NoScratch;
  const LevelBox* boxes;
  const PrimitiveIndex* listed;
  const LeafCounts *starts, *below; // `below`: the next level's leaves, box by box
  LeafCounts* next_starts;
  MergedCell* cells;
  PrimitiveIndex* references;

  MASU_HD std::uint32_t size(std::uint64_t i) const {
    return boxes[i].child == no_child ? boxes[i].end - boxes[i].begin : 0;
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    const LevelBox& box = boxes[i];
    const LeafCounts start = starts[i];
    for (std::uint32_t r = group.thread_rank(); r < size(i); r += group.size())
      references[start.references + r] = listed[box.begin + r] | (r + 1 == size(i) ? last_bit : 0);
    if (group.thread_rank() != 0) return;
    if (box.child == no_child) {
      cells[start.leaves] = packed(box.box, size(i) > 0 ? start.references : empty_list);
      return;
    }
    next_starts[box.child] = start;
    next_starts[box.child + 1] = start + below[box.child];
  }
};

// `starts` says of each box of the first level how many cells and references are before it.
template <class Executor>
void write_leaves(Executor& executor, const std::vector<SplitLevel<Executor>>& levels,
                  const std::vector<ArrayOf<Executor, LeafCounts>>& counts, const LeafCounts* starts,
                  ExecutorStructure<Executor>& grid) {
  ArrayOf<Executor, LeafCounts> own_starts{};
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    auto next_starts = executor.template array<LeafCounts>(levels[level + 1].boxes.size());
    executor.for_each_by_group(levels[level].boxes.size(),
                               WriteLeaves{levels[level].boxes.data(), levels[level].listed.data(), starts,
                                           counts[level + 1].data(), next_starts.data(), grid.cells.data(),
                                           grid.references.data()});
    own_starts = std::move(next_starts);
    starts = own_starts.data();
  }
}

} // namespace masu
