// Splitting many boxes at once: level by level what split.h does box by box.
#pragma once

#include "libgrid/build/executor.h"
#include "libgrid/build/merge.h"
#include "libgrid/build/splitter.h"
#include "libgrid/build/uniform_passes.h"

#include <optional>
#include <vector>

namespace masu {

inline constexpr std::uint32_t no_child = 0xffffffffU;

// A box of a level. While it is open, `begin` … `end` - 1 are its fragments; a leaf's are its references
// among its level's, in the end.
struct LevelBox {
  VoxelBox box;
  std::uint32_t begin, end;
  std::int32_t axis, at; // the plane that divides it
  std::uint32_t child;   // its number on the next level is that of what is below; what is above follows
};

struct LeafReference {
  PrimitiveIndex primitive;
  std::uint32_t box; // which lists it
};

template <class Executor>
struct SplitLevel {
  ArrayOf<Executor, LevelBox> boxes{};
  ArrayOf<Executor, LeafReference> listed{}; // leaf by leaf
};

template <class Executor>
struct OpenFragments {
  ArrayOf<Executor, Fragment> fragments{};
  ArrayOf<Executor, std::uint32_t> box_of{};
};

// Of the fragments before some place: how many there are of below a plane and above it; how many leaves list.
struct FragmentCounts {
  std::uint32_t below, above, listed;
  friend MASU_HD FragmentCounts operator+(const FragmentCounts& a, const FragmentCounts& b) {
    return {a.below + b.below, a.above + b.above, a.listed + b.listed};
  }
};

template <class Stored>
struct ChoosePlanes {
  using Scratch = PlaneBins;
  Splitter<Stored> splitter;
  LevelBox* boxes;
  const Fragment* fragments;

  MASU_HD std::uint32_t size(std::uint64_t i) const { return boxes[i].end - boxes[i].begin; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, PlaneBins& bins, std::uint64_t i) const {
    LevelBox& own = boxes[i];
    const Plane plane = splitter.cheapest_plane(group, bins, own.box, fragments + own.begin, size(i));
    if (group.thread_rank() != 0) return;
    own.axis = plane.axis;
    own.at = plane.at;
    own.child = is_plane(plane) ? 0 : no_child;
  }
};

// Says of every fragment on which sides of its box's plane it is, or whether the leaf it is in lists it: the
// counts before it, and after the last. A fragment that is on both sides stays in its place as what is below,
// and is in `above` as what is above.
template <class Executor, class Stored>
ArrayOf<Executor, FragmentCounts> count_fragments(Executor& executor, const Splitter<Stored>& splitter,
                                                  const LevelBox* boxes, OpenFragments<Executor>& open,
                                                  Fragment* above) {
  const std::uint64_t count = open.fragments.size();
  Fragment* const fragments = open.fragments.data();
  const std::uint32_t* const box_of = open.box_of.data();
  // Most fragments are on one side. Those that look at their primitive are put on lists, so that the threads
  // of a warp all have one to look at.
  auto counts = executor.template array<FragmentCounts>(count + 1);
  auto lists = executor.template array<std::uint32_t>(2 * count);
  auto lengths = executor.template zeros<std::uint32_t>(2);
  FragmentCounts* const before = counts.data();
  std::uint32_t *const cut = lists.data(), *const in_leaf = lists.data() + count,
                       *const length = lengths.data();
  executor.for_each(count + 1, [=] MASU_PASS(std::uint64_t i) {
    if (i == count) {
      before[i] = {0, 0, 0};
      return;
    }
    const LevelBox& own = boxes[box_of[i]];
    if (own.child == no_child) {
      in_leaf[counted(length[1], 1)] = static_cast<std::uint32_t>(i);
      return;
    }
    const auto sides = splitter.sides_of_fragment(fragments[i], Plane{own.axis, own.at, 0});
    if (sides.below && sides.above) {
      cut[counted(length[0], 1)] = static_cast<std::uint32_t>(i);
    } else {
      before[i] = {sides.below ? 1U : 0U, sides.above ? 1U : 0U, 0};
    }
  });
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    if (i >= length[0]) return;
    const std::uint32_t fragment = cut[i];
    const LevelBox& own = boxes[box_of[fragment]];
    Fragment low{}, high{};
    const auto sides = splitter.cut(fragments[fragment], Plane{own.axis, own.at, 0}, low, high);
    before[fragment] = {sides.below ? 1U : 0U, sides.above ? 1U : 0U, 0};
    fragments[fragment] = sides.below ? low : high;
    if (sides.below && sides.above) above[fragment] = high;
  });
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    if (i >= length[1]) return;
    const std::uint32_t fragment = in_leaf[i];
    before[fragment] = {0, 0,
                        splitter.lists(boxes[box_of[fragment]].box, fragments[fragment].primitive) ? 1U : 0U};
  });
  executor.scan(counts);
  return counts;
}

// The next level's fragments: of each divided box those below, then those above, in their order. What leaves
// list goes to `listed`. `divided_before` numbers the boxes that are divided.
template <class Executor>
OpenFragments<Executor> move_fragments(Executor& executor, const LevelBox* boxes,
                                       const OpenFragments<Executor>& open, const Fragment* above,
                                       const FragmentCounts* before, const std::uint32_t* split_before,
                                       std::uint64_t next_count, LeafReference* listed) {
  OpenFragments<Executor> next{executor.template array<Fragment>(next_count),
                               executor.template array<std::uint32_t>(next_count)};
  const Fragment* const fragments = open.fragments.data();
  const std::uint32_t* const box_of = open.box_of.data();
  Fragment* const next_fragments = next.fragments.data();
  std::uint32_t* const next_box_of = next.box_of.data();
  executor.for_each(open.fragments.size(), [=] MASU_PASS(std::uint64_t i) {
    const FragmentCounts here = before[i], after = before[i + 1];
    const std::uint32_t box = box_of[i], child = 2 * split_before[box];
    const FragmentCounts first = before[boxes[box].begin];
    const std::uint32_t begin = first.below + first.above;
    const bool is_below = after.below != here.below, is_above = after.above != here.above;
    if (is_below) {
      const std::uint32_t at = begin + here.below - first.below;
      next_fragments[at] = fragments[i];
      next_box_of[at] = child;
    }
    if (is_above) {
      const std::uint32_t all_below = before[boxes[box].end].below - first.below;
      const std::uint32_t at = begin + all_below + here.above - first.above;
      next_fragments[at] = is_below ? above[i] : fragments[i];
      next_box_of[at] = child + 1;
    }
    if (after.listed != here.listed) listed[here.listed] = {fragments[i].primitive, box};
  });
  return next;
}

// Divides the level's boxes, once or not at all, and returns the next level's, if there aren't too many
// fragments. `open` are the boxes' fragments, and afterwards those of the next level's.
template <class Executor, class Stored>
std::optional<SplitLevel<Executor>> split_level(Executor& executor, const Splitter<Stored>& splitter,
                                                SplitLevel<Executor>& level, OpenFragments<Executor>& open) {
  LevelBox* const boxes = level.boxes.data();
  const std::uint64_t box_count = level.boxes.size(), fragment_count = open.fragments.size();
  executor.for_each_by_group(box_count, ChoosePlanes<Stored>{splitter, boxes, open.fragments.data()});
  const auto divided =
      numbered(executor, box_count, [=] MASU_PASS(std::uint64_t i) { return boxes[i].child != no_child; });
  const std::uint32_t* const split_before = divided.data();

  auto above = executor.template array<Fragment>(fragment_count);
  const auto counts = count_fragments(executor, splitter, boxes, open, above.data());
  const FragmentCounts all = executor.value(counts, fragment_count);
  const std::uint64_t next_count = std::uint64_t{all.below} + all.above;
  if (next_count > most_numbered) return std::nullopt;
  level.listed = executor.template array<LeafReference>(all.listed);
  const FragmentCounts* const before = counts.data();
  open = move_fragments(executor, boxes, open, above.data(), before, split_before, next_count,
                        level.listed.data());

  SplitLevel<Executor> next{
      executor.template array<LevelBox>(2 * std::uint64_t{executor.value(divided, box_count)}), {}};
  LevelBox* const next_boxes = next.boxes.data();
  executor.for_each(box_count, [=] MASU_PASS(std::uint64_t i) {
    LevelBox& own = boxes[i];
    const FragmentCounts first = before[own.begin], last = before[own.end];
    if (own.child == no_child) {
      own.begin = first.listed;
      own.end = last.listed;
      return;
    }
    own.child = 2 * split_before[i];
    const std::uint32_t begin = first.below + first.above, end = last.below + last.above;
    LevelBox low{own.box, begin, begin + last.below - first.below, 0, 0, no_child};
    LevelBox high{own.box, low.end, end, 0, 0, no_child};
    low.box.end.set(own.axis, own.at);
    high.box.first.set(own.axis, own.at);
    next_boxes[own.child] = low;
    next_boxes[own.child + 1] = high;
  });
  return next;
}

// All levels, from the one given down; the last has no boxes. None where there are too many fragments.
template <class Executor, class Stored>
std::vector<SplitLevel<Executor>> split_all(Executor& executor, const Splitter<Stored>& splitter,
                                            SplitLevel<Executor> first, OpenFragments<Executor> open) {
  std::vector<SplitLevel<Executor>> levels;
  levels.push_back(std::move(first));
  while (levels.back().boxes.size() > 0) {
    auto next = split_level(executor, splitter, levels.back(), open);
    if (!next) return {};
    levels.push_back(std::move(*next));
  }
  return levels;
}

// What exceeds where there are more leaves, or references of them, than can be numbered.
template <class Executor>
const char* exceeded_by_leaves(const std::vector<SplitLevel<Executor>>& levels) {
  if (levels.empty()) return too_many_cells;
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

// Writes all leaves as cells, and what they list. `starts` says of each box of the first level how many cells
// and references are before it.
template <class Executor>
void write_leaves(Executor& executor, const std::vector<SplitLevel<Executor>>& levels,
                  const std::vector<ArrayOf<Executor, LeafCounts>>& counts,
                  ArrayOf<Executor, LeafCounts> starts, ExecutorGrid<Executor>& grid) {
  MergedCell* const cells = grid.cells.data();
  PrimitiveIndex* const references = grid.references.data();
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    auto next_starts = executor.template array<LeafCounts>(levels[level + 1].boxes.size());
    const LevelBox* const boxes = levels[level].boxes.data();
    const LeafCounts* const own = starts.data();
    const LeafCounts* const below = counts[level + 1].data();
    LeafCounts* const next = next_starts.data();
    executor.for_each(levels[level].boxes.size(), [=] MASU_PASS(std::uint64_t i) {
      const LevelBox& box = boxes[i];
      if (box.child == no_child) {
        cells[own[i].leaves] = packed(box.box, box.end > box.begin ? own[i].references : empty_list);
        return;
      }
      next[box.child] = own[i];
      next[box.child + 1] = own[i] + below[box.child];
    });
    const LeafReference* const listed = levels[level].listed.data();
    executor.for_each(levels[level].listed.size(), [=] MASU_PASS(std::uint64_t i) {
      const LevelBox& box = boxes[listed[i].box];
      const auto place = static_cast<std::uint32_t>(i);
      references[own[listed[i].box].references + place - box.begin] =
          listed[i].primitive | (place + 1 == box.end ? last_bit : 0);
    });
    starts = std::move(next_starts);
  }
}

} // namespace masu
