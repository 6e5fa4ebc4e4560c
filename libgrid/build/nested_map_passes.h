// The maps of many divided cubes at once, by passes (executor.h): level by level what nested_map.h does cube
// by cube.
#pragma once

#include "libgrid/build/executor.h"
#include "libgrid/build/merge.h"
#include "libgrid/build/nested_map.h"
#include "libgrid/build/uniform_passes.h"

#include <vector>

namespace masu {

// A place that several cells divide between them: `begin` … `end` - 1 of its level's entries. Its words are
// its level's from `words` on.
struct MapBox {
  MapPlace place;
  Vec3i division;
  std::uint32_t begin, end, words;
  std::uint32_t child, children; // those of its parts that several cells divide: numbers on the next level
  std::uint32_t parent_word;     // the level before's that leads here
};

MASU_HD inline MapBox undivided(const MapPlace& place, std::uint64_t begin, std::uint64_t end,
                                std::uint32_t parent_word) {
  return {place, {},         static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), 0, 0,
          0,     parent_word};
}

// Cells, place by place.
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
        planes[axis] |= plane_bits(own.place, cell, axis);
    }
    for (std::uint32_t& bits : planes)
      bits = group.all_bits(bits);
    if (group.thread_rank() == 0) own.division = map_division_for(own.place, planes, size(i));
  }
};

struct CopyMapWords {
  using Scratch = NoScratch;
  const MapBox* boxes;
  const std::uint32_t* places; // of the boxes in the whole map
  const std::uint32_t* words;
  std::uint32_t* map;

  MASU_HD std::uint32_t size(std::uint64_t i) const {
    return static_cast<std::uint32_t>(rounded_to_unit(parts_of(boxes[i].division)));
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    for (std::uint32_t word = group.thread_rank(); word < size(i); word += group.size())
      map[places[i] + word] = words[boxes[i].words + word];
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

// Fills in the level's boxes and words, the places of what they lead to excepted, and returns the boxes of
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

  // How many cells each part is in.
  auto part_cells = executor.template zeros<std::uint32_t>(word_count);
  std::uint32_t* const inside = part_cells.data();
  executor.for_each(entry_count, [=] MASU_PASS(std::uint64_t i) {
    const MapBox& own = boxes[entry_box[i]];
    for_each_voxel(map_parts(own.place, own.division, box_of(cells[entry_cell[i]])), [&](const Vec3i& part) {
      counted(inside[begin[entry_box[i]] + index_in_division(part, own.division)], 1);
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

  level.words = executor.template zeros<std::uint32_t>(word_count);
  MapLevel<Executor> next{executor.template array<MapBox>(all.children), {}};
  MapEntries<Executor> next_entries{executor.template array<std::uint32_t>(all.entries),
                                    executor.template array<std::uint32_t>(all.entries)};
  std::uint32_t* const words = level.words.data();
  std::uint32_t* const next_cell = next_entries.cells.data();
  std::uint32_t* const next_box = next_entries.box_of.data();
  executor.for_each(entry_count, [=] MASU_PASS(std::uint64_t i) {
    const MapBox& own = boxes[entry_box[i]];
    for_each_voxel(map_parts(own.place, own.division, box_of(cells[entry_cell[i]])), [&](const Vec3i& part) {
      const std::uint64_t word = begin[entry_box[i]] + index_in_division(part, own.division);
      const WordCounts here = before[word], after = before[word + 1];
      if (after.children == here.children) {
        words[word] = occupied_bit | entry_cell[i];
        return;
      }
      // In any order: what becomes of them depends on none.
      const std::uint64_t at = here.entries + counted(inside[word], ~0U) - 1;
      next_cell[at] = entry_cell[i];
      next_box[at] = here.children;
    });
  });
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
          undivided(map_part(own.place, own.division, part), here.entries, after.entries, own.words + part);
    }
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

// Writes the words of all levels. `places` says of the first level's boxes where their words are to begin.
template <class Executor>
void write_maps(Executor& executor, std::vector<MapLevel<Executor>>& levels,
                const std::vector<ArrayOf<Executor, std::uint32_t>>& counts,
                ArrayOf<Executor, std::uint32_t> places, ArrayOf<Executor, std::uint32_t>& map) {
  for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
    auto next_places = executor.template array<std::uint32_t>(levels[level + 1].boxes.size());
    const MapBox* const boxes = levels[level].boxes.data();
    const MapBox* const next_boxes = levels[level + 1].boxes.data();
    const std::uint32_t* const place = places.data();
    const std::uint32_t* const below = counts[level + 1].data();
    std::uint32_t* const words = levels[level].words.data();
    std::uint32_t* const next = next_places.data();
    executor.for_each(levels[level].boxes.size(), [=] MASU_PASS(std::uint64_t i) {
      const MapBox& box = boxes[i];
      std::uint32_t at = place[i] + static_cast<std::uint32_t>(rounded_to_unit(parts_of(box.division)));
      for (std::uint32_t child = box.child; child < box.child + box.children; ++child) {
        next[child] = at;
        words[next_boxes[child].parent_word] = map_word({at, next_boxes[child].division});
        at += below[child];
      }
    });
    executor.for_each_by_group(levels[level].boxes.size(), CopyMapWords{boxes, place, words, map.data()});
    places = std::move(next_places);
  }
}

} // namespace masu
