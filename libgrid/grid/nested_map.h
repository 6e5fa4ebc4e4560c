// The maps that lead from the smallest voxels to their cells (grid.h has the words), of many divided
// voxels at once, level by level: each pass does something to all regions of a level, or to all cells in
// them.
#pragma once

#include "libgrid/grid/merge.h"
#include "libgrid/grid/uniform_passes.h"
#include "libscene/base/atomic.h"
#include "libscene/passes/executor.h"

#include <algorithm>
#include <vector>

namespace masu {

// No more words than this for each cell that they lead to, unless one step down needs them: what is left of
// the depth takes another step.
inline constexpr std::uint32_t words_per_cell = 4;

// 2^log2 voxels along each axis.
struct MapRegion {
  Vec3i first, log2;
};

MASU_HD inline std::uint32_t parts_of(const Vec3i& division) {
  return 1U << (division.x + division.y + division.z);
}

// Words begin at multiples of the unit.
MASU_HD inline std::uint64_t rounded_to_unit(std::uint64_t words) {
  constexpr std::uint64_t rest = (std::uint64_t{1} << offset_unit_log2) - 1;
  return (words + rest) & ~rest;
}

// The bits of where a cell's planes are within the region along an axis, counted from its beginning.
MASU_HD inline std::uint32_t plane_bits(const MapRegion& region, const VoxelBox& cell, int axis) {
  const auto bits_of_plane = [&](std::int32_t plane) {
    const std::int32_t offset = plane - region.first[axis];
    return offset > 0 && offset < (1 << region.log2[axis]) ? static_cast<std::uint32_t>(offset) : 0U;
  };
  return bits_of_plane(cell.first[axis]) | bits_of_plane(cell.end[axis]);
}

// How often a region that so many cells divide between them is divided along each axis: so often that every
// part is in one cell, if that doesn't take too many words. `planes`: all their bits.
MASU_HD inline Vec3i map_division_for(const MapRegion& region, const std::uint32_t (&planes)[3],
                                      std::uint32_t cells) {
  Vec3i division{};
  for (int axis = 0; axis < 3; ++axis) {
    std::int32_t finest = 0;
    while (finest < region.log2[axis] && (planes[axis] >> finest & 1) == 0)
      ++finest;
    division.set(axis, std::min(region.log2[axis] - finest, static_cast<std::int32_t>(max_division_log2)));
  }
  while (parts_of(division) > 2 && parts_of(division) > std::uint64_t{words_per_cell} * cells) {
    const int axis = division.x >= division.y && division.x >= division.z ? 0
                     : division.y >= division.z                           ? 1
                                                                          : 2;
    division.set(axis, division[axis] - 1);
  }
  return division;
}

// The parts of the divided region that a cell has some of, and a part's own region.
MASU_HD inline VoxelRange map_parts(const MapRegion& region, const Vec3i& division, const VoxelBox& cell) {
  VoxelRange parts{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t rest = region.log2[axis] - division[axis], from = region.first[axis];
    parts.first.set(axis, std::max(cell.first[axis] - from, 0) >> rest);
    parts.last.set(axis, std::min((cell.end[axis] - 1 - from) >> rest, (1 << division[axis]) - 1));
  }
  return parts;
}
MASU_HD inline MapRegion map_part(const MapRegion& region, const Vec3i& division, std::uint32_t part) {
  MapRegion own{region.first, region.log2 - division};
  std::uint32_t rest = part;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t index = rest & ((1U << division[axis]) - 1);
    own.first.set(axis, region.first[axis] + static_cast<std::int32_t>(index << own.log2[axis]));
    rest >>= division[axis];
  }
  return own;
}

// A region that several cells divide between them: `begin` … `end` - 1 of its level's entries. Its words are
// its level's from `words` on.
struct MapBox {
  MapRegion region;
  Vec3i division;
  std::uint32_t begin, end, words;
  std::uint32_t child,
      children;              // the first of its parts that several cells divide, on the next level; how many
  std::uint32_t parent_word; // index of the word that leads here, on the level before
};

MASU_HD inline MapBox undivided(const MapRegion& region, std::uint64_t begin, std::uint64_t end,
                                std::uint32_t parent_word) {
  return {region, {},         static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), 0, 0,
          0,      parent_word};
}

// Cells, region by region.
template <class Executor>
struct MapEntries {
  ArrayOf<Executor, std::uint32_t> cells{}, box_of{};
};

template <class Executor>
struct MapLevel {
  ArrayOf<Executor, MapBox> boxes{};
  ArrayOf<Executor, std::uint32_t> words{};
};

struct DivideMapBoxes {
  using Scratch = NoScratch;
  MapBox* boxes;
  const MergedCell* cells;
  const std::uint32_t* entries;

  MASU_HD std::uint32_t size(std::uint64_t i) const { return boxes[i].end - boxes[i].begin; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    MapBox& own = boxes[i];
    std::uint32_t planes[3] = {};
    for (std::uint32_t entry = own.begin + group.thread_rank(); entry < own.end; entry += group.size()) {
      const VoxelBox cell = box_of(cells[entries[entry]]);
      for (int axis = 0; axis < 3; ++axis)
        planes[axis] |= plane_bits(own.region, cell, axis);
    }
    for (std::uint32_t& bits : planes)
      bits = group.all_bits(bits);
    if (group.thread_rank() == 0) own.division = map_division_for(own.region, planes, size(i));
  }
};

struct CopyMapWords {
  using Scratch = NoScratch;
  const MapBox* boxes;
  const std::uint32_t* offsets; // of the boxes' words in the whole map
  const std::uint32_t* words;
  std::uint32_t* map;

  MASU_HD std::uint32_t size(std::uint64_t i) const {
    return static_cast<std::uint32_t>(rounded_to_unit(parts_of(boxes[i].division)));
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    for (std::uint32_t word = group.thread_rank(); word < size(i); word += group.size())
      map[offsets[i] + word] = words[boxes[i].words + word];
  }
};

// Of the words before some one: how many lead on, and to how many entries.
struct WordCounts {
  std::uint32_t children;
  std::uint64_t entries;
  friend MASU_HD WordCounts operator+(const WordCounts& a, const WordCounts& b) {
    return {a.children + b.children, a.entries + b.entries};
  }
};

// Fills in the level's boxes and words, except for words that lead on, and returns the boxes of
// the next level. `entries` are the level's, and afterwards those of the next. Sets `exceeded` and returns
// nothing where there would be too many.
template <class Executor>
MapLevel<Executor> divide_map_level(Executor& executor, const MergedCell* cells, MapLevel<Executor>& level,
                                    MapEntries<Executor>& entries, const char*& exceeded) {
  MapBox* const boxes = level.boxes.data();
  const std::uint32_t* const entry_cell = entries.cells.data();
  const std::uint32_t* const entry_box = entries.box_of.data();
  const std::uint64_t box_count = level.boxes.size(), entry_count = entries.cells.size();
  executor.for_each_by_group(box_count, DivideMapBoxes{boxes, cells, entry_cell});

  auto begins = executor.template array<std::uint64_t>(box_count + 1);
  std::uint64_t* const begin = begins.data();
  executor.for_each(box_count + 1, [=] MASU_PASS(std::uint64_t i) {
    begin[i] = i == box_count ? 0 : rounded_to_unit(parts_of(boxes[i].division));
  });
  executor.scan(begins);
  const std::uint64_t word_count = executor.value(begins, box_count);
  if ((exceeded = exceeded_by_sizes(0, 0, 0, word_count)) != nullptr) return {};

  // How many cells each part is in. The first of them writes its word: final where it is the only one.
  level.words = executor.template zeros<std::uint32_t>(word_count);
  auto part_cells = executor.template zeros<std::uint32_t>(word_count);
  std::uint32_t *const words = level.words.data(), *const inside = part_cells.data();
  executor.for_each(entry_count, [=] MASU_PASS(std::uint64_t i) {
    const MapBox& own = boxes[entry_box[i]];
    const std::uint64_t first_word = begin[entry_box[i]];
    for_each_voxel(map_parts(own.region, own.division, box_of(cells[entry_cell[i]])), [&](const Vec3i& part) {
      const std::uint64_t word = first_word + index_in_division(part, own.division);
      if (added(inside[word], 1) == 0) words[word] = occupied_bit | entry_cell[i];
    });
  });
  auto counts = executor.template array<WordCounts>(word_count + 1);
  WordCounts* const before = counts.data();
  executor.for_each(word_count + 1, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t sharing = i != word_count && inside[i] > 1 ? inside[i] : 0U;
    before[i] = {sharing > 0 ? 1U : 0U, sharing};
  });
  executor.scan(counts);
  const WordCounts all = executor.value(counts, word_count);
  if ((exceeded = exceeded_by_sizes(all.entries, 0, 0, 0)) != nullptr) return {};

  MapLevel<Executor> next{executor.template array<MapBox>(all.children), {}};
  MapEntries<Executor> next_entries{executor.template array<std::uint32_t>(all.entries),
                                    executor.template array<std::uint32_t>(all.entries)};
  MapBox* const next_boxes = next.boxes.data();
  executor.for_each(box_count, [=] MASU_PASS(std::uint64_t i) {
    MapBox& own = boxes[i];
    own.words = static_cast<std::uint32_t>(begin[i]);
    own.child = before[begin[i]].children;
    own.children = before[begin[i + 1]].children - own.child;
    for (std::uint32_t part = 0; own.children > 0 && part < parts_of(own.division); ++part) {
      const WordCounts here = before[begin[i] + part], after = before[begin[i] + part + 1];
      if (after.children == here.children) continue;
      next_boxes[here.children] =
          undivided(map_part(own.region, own.division, part), here.entries, after.entries, own.words + part);
    }
  });
  std::uint32_t *const next_cell = next_entries.cells.data(), *const next_box = next_entries.box_of.data();
  executor.for_each(entry_count, [=] MASU_PASS(std::uint64_t i) {
    const MapBox& own = boxes[entry_box[i]];
    if (own.children == 0) return;
    for_each_voxel(map_parts(own.region, own.division, box_of(cells[entry_cell[i]])), [&](const Vec3i& part) {
      const std::uint64_t word = own.words + index_in_division(part, own.division);
      const WordCounts here = before[word];
      if (before[word + 1].children == here.children) return;
      // In any order: what becomes of them depends on none.
      const std::uint64_t entry = here.entries + added(inside[word], ~0U) - 1;
      next_cell[entry] = entry_cell[i];
      next_box[entry] = here.children;
    });
  });
  entries = std::move(next_entries);
  return next;
}

// Of every level's boxes: how many words there are of each, and of all that it leads to.
template <class Executor>
std::vector<ArrayOf<Executor, std::uint32_t>> count_words(Executor& executor,
                                                          const std::vector<MapLevel<Executor>>& levels) {
  std::vector<ArrayOf<Executor, std::uint32_t>> counts(levels.size());
  for (std::size_t level = levels.size(); level-- > 0;) {
    const std::uint64_t count = levels[level].boxes.size();
    counts[level] = executor.template array<std::uint32_t>(count);
    const MapBox* const boxes = levels[level].boxes.data();
    std::uint32_t* const own = counts[level].data();
    const std::uint32_t* const below = level + 1 < levels.size() ? counts[level + 1].data() : nullptr;
    executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
      const MapBox& box = boxes[i];
      auto words = static_cast<std::uint32_t>(rounded_to_unit(parts_of(box.division)));
      for (std::uint32_t child = box.child; child < box.child + box.children; ++child)
        words += below[child];
      own[i] = words;
    });
  }
  return counts;
}

// Writes the words of all levels. `offsets` says of the first level's boxes where their words are to begin.
template <class Executor>
void write_maps(Executor& executor, std::vector<MapLevel<Executor>>& levels,
                const std::vector<ArrayOf<Executor, std::uint32_t>>& counts,
                ArrayOf<Executor, std::uint32_t> offsets, ArrayOf<Executor, std::uint32_t>& map) {
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    auto next_offsets = executor.template array<std::uint32_t>(levels[level + 1].boxes.size());
    const MapBox* const boxes = levels[level].boxes.data();
    const MapBox* const next_boxes = levels[level + 1].boxes.data();
    const std::uint32_t* const offset = offsets.data();
    const std::uint32_t* const below = counts[level + 1].data();
    std::uint32_t* const words = levels[level].words.data();
    std::uint32_t* const next = next_offsets.data();
    executor.for_each(levels[level].boxes.size(), [=] MASU_PASS(std::uint64_t i) {
      const MapBox& box = boxes[i];
      std::uint32_t words_end =
          offset[i] + static_cast<std::uint32_t>(rounded_to_unit(parts_of(box.division)));
      for (std::uint32_t child = box.child; child < box.child + box.children; ++child) {
        next[child] = words_end;
        words[next_boxes[child].parent_word] = map_word({words_end, next_boxes[child].division});
        words_end += below[child];
      }
    });
    executor.for_each_by_group(levels[level].boxes.size(), CopyMapWords{boxes, offset, words, map.data()});
    offsets = std::move(next_offsets);
  }
}

} // namespace masu
