// Building an irregular grid by passes (executor.h), in this order: uniform_passes.h, split_passes.h,
// nested_map_passes.h, expand_passes.h. The same bytes as merged_grid's (merge.h).
#pragma once

#include "libgrid/build/expand_passes.h"
#include "libgrid/build/nested_map_passes.h"
#include "libgrid/build/split_passes.h"

namespace masu {

// The voxels of a uniform grid that hold something: where, and which pairs.
template <class Executor>
struct OccupiedVoxels {
  ArrayOf<Executor, std::uint32_t> places{};  // in rising order
  ArrayOf<Executor, std::uint32_t> begins{};  // one more than there are voxels
  ArrayOf<Executor, std::uint32_t> numbers{}; // of each pair: how many voxels begin before it
};

template <class Executor>
OccupiedVoxels<Executor> occupied_voxels(Executor& executor, const VoxelPairs<Executor>& pairs) {
  const std::uint64_t count = pairs.keys.size();
  const std::uint64_t* const place = pairs.keys.data();
  OccupiedVoxels<Executor> occupied;
  occupied.numbers = numbered(executor, count,
                              [=] MASU_PASS(std::uint64_t i) { return i == 0 || place[i] != place[i - 1]; });
  const std::uint32_t voxels = executor.value(occupied.numbers, count);
  occupied.places = executor.template array<std::uint32_t>(voxels);
  occupied.begins = executor.template array<std::uint32_t>(std::uint64_t{voxels} + 1);
  const std::uint32_t* const number = occupied.numbers.data();
  std::uint32_t* const voxel_place = occupied.places.data();
  std::uint32_t* const begin = occupied.begins.data();
  executor.for_each(count + 1, [=] MASU_PASS(std::uint64_t i) {
    if (i == count) begin[voxels] = static_cast<std::uint32_t>(count);
    if (i == count || number[i + 1] == number[i]) return;
    voxel_place[number[i]] = static_cast<std::uint32_t>(place[i]);
    begin[number[i]] = static_cast<std::uint32_t>(i);
  });
  return occupied;
}

MASU_HD inline Vec3i voxel_at(std::uint32_t place, const Vec3i& division) {
  const auto x = static_cast<std::uint32_t>(division.x), y = static_cast<std::uint32_t>(division.y);
  return {static_cast<std::int32_t>(place % x), static_cast<std::int32_t>(place / x % y),
          static_cast<std::int32_t>(place / x / y)};
}

// Voxels first … end - 1, in voxels 2^log2 times smaller.
MASU_HD inline VoxelBox nested_box(const Vec3i& first, const Vec3i& end, std::int32_t log2) {
  return {{first.x << log2, first.y << log2, first.z << log2}, {end.x << log2, end.y << log2, end.z << log2}};
}

// The voxels as boxes to be divided, and their parts.
template <class Executor, class Stored>
SplitLevel<Executor> first_level(Executor& executor, const Splitter<Stored>& splitter, const Vec3i& division,
                                 std::int32_t nested_log2, const VoxelPairs<Executor>& pairs,
                                 const OccupiedVoxels<Executor>& occupied, OpenFragments<Executor>& open) {
  const std::uint64_t count = pairs.values.size(), voxels = occupied.places.size();
  auto all = executor.template array<Fragment>(count);
  auto kept = executor.template array<std::uint32_t>(count + 1);
  Fragment* const fragment = all.data();
  std::uint32_t* const kept_before = kept.data();
  const PrimitiveIndex* const primitive = pairs.values.data();
  const std::uint32_t* const number = occupied.numbers.data();
  const std::uint32_t* const place = occupied.places.data();
  const std::uint32_t* const begin = occupied.begins.data();
  executor.for_each(count + 1, [=] MASU_PASS(std::uint64_t i) {
    kept_before[i] = 0;
    if (i == count) return;
    const Vec3i voxel = voxel_at(place[number[i + 1] - 1], division);
    const VoxelBox box = nested_box(voxel, voxel + Vec3i{1, 1, 1}, nested_log2);
    kept_before[i] = splitter.fragment_in(box, primitive[i], fragment[i]) ? 1 : 0;
  });
  executor.scan(kept);
  const std::uint32_t fragments = executor.value(kept, count);

  open.fragments = executor.template array<Fragment>(fragments);
  open.box_of = executor.template array<std::uint32_t>(fragments);
  Fragment* const open_fragment = open.fragments.data();
  std::uint32_t* const box_of_fragment = open.box_of.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    if (kept_before[i + 1] == kept_before[i]) return;
    open_fragment[kept_before[i]] = fragment[i];
    box_of_fragment[kept_before[i]] = number[i + 1] - 1;
  });
  SplitLevel<Executor> level{executor.template array<LevelBox>(voxels), {}};
  LevelBox* const boxes = level.boxes.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) {
    const Vec3i voxel = voxel_at(place[i], division);
    boxes[i] = {nested_box(voxel, voxel + Vec3i{1, 1, 1}, nested_log2),
                kept_before[begin[i]],
                kept_before[begin[i + 1]],
                0,
                0,
                no_child};
  });
  return level;
}

// How many cells there are before each voxel of the division, and at its end before no more: those of the
// occupied ones, and one for each run along x of those that hold nothing.
template <class Executor>
ArrayOf<Executor, std::uint32_t> cells_before_voxels(Executor& executor, const Vec3i& division,
                                                     const std::uint32_t* occupied_number,
                                                     const LeafCounts* leaves) {
  const std::uint64_t voxels = voxel_count(division);
  auto cells = executor.template array<std::uint32_t>(voxels + 1);
  std::uint32_t* const before = cells.data();
  const auto row = static_cast<std::uint32_t>(division.x);
  executor.for_each(voxels + 1, [=] MASU_PASS(std::uint64_t i) {
    if (i == voxels) {
      before[i] = 0;
    } else if (occupied_number[i] != 0) {
      before[i] = leaves[occupied_number[i] - 1].leaves;
    } else {
      before[i] = i % row == 0 || occupied_number[i - 1] != 0 ? 1 : 0;
    }
  });
  executor.scan(cells);
  return cells;
}

// The cells of runs of empty voxels, and the words of their voxels.
template <class Executor>
void write_empty_runs(Executor& executor, const Vec3i& division, const std::uint32_t* occupied_number,
                      const std::uint32_t* cells_before, ExecutorGrid<Executor>& grid) {
  MergedCell* const cells = grid.cells.data();
  std::uint32_t* const map = grid.voxel_map.data();
  const std::int32_t log2 = grid.nested_log2;
  executor.for_each(voxel_count(division), [=] MASU_PASS(std::uint64_t i) {
    if (occupied_number[i] != 0) return;
    const bool begins = cells_before[i + 1] != cells_before[i];
    const std::uint32_t cell = begins ? cells_before[i] : cells_before[i] - 1;
    map[i] = occupied_bit | cell;
    if (!begins) return;
    const Vec3i first = voxel_at(static_cast<std::uint32_t>(i), division);
    Vec3i end = first + Vec3i{1, 1, 1};
    while (end.x < division.x && occupied_number[i + static_cast<std::uint32_t>(end.x - first.x)] == 0)
      ++end.x;
    cells[cell] = packed(nested_box(first, end, log2), empty_list);
  });
}

// The maps of the occupied voxels, cubes of the nested division. Makes the grid's map as large as it has to
// be. `starts` and `leaves` say of each voxel where its cells begin, and how many they are.
template <class Executor>
void write_nested_maps(Executor& executor, const Vec3i& division,
                       const ArrayOf<Executor, std::uint32_t>& places, const LeafCounts* starts,
                       const LeafCounts* leaves, ExecutorGrid<Executor>& grid) {
  const std::uint64_t voxels = places.size(), top_words = rounded_to_unit(voxel_count(division));
  const std::uint32_t* const place = places.data();
  const std::int32_t log2 = grid.nested_log2;
  // Those of several cells, and their entries.
  auto several = executor.template array<WordCounts>(voxels + 1);
  WordCounts* const before = several.data();
  executor.for_each(voxels + 1, [=] MASU_PASS(std::uint64_t i) {
    const std::uint32_t own = i != voxels && leaves[i].leaves > 1 ? leaves[i].leaves : 0;
    before[i] = {own > 0 ? 1U : 0U, own};
  });
  executor.scan(several);
  const WordCounts all = executor.value(several, voxels);

  std::vector<MapLevel<Executor>> levels(1);
  levels[0].boxes = executor.template array<MapBox>(all.children);
  MapEntries<Executor> entries{executor.template array<std::uint32_t>(all.entries),
                               executor.template array<std::uint32_t>(all.entries)};
  MapBox* const boxes = levels[0].boxes.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) {
    const WordCounts here = before[i], after = before[i + 1];
    if (after.children == here.children) return;
    const Vec3i voxel = voxel_at(place[i], division);
    const MapPlace cube{nested_box(voxel, voxel, log2).first, {log2, log2, log2}};
    boxes[here.children] = undivided(cube, here.entries, after.entries, static_cast<std::uint32_t>(i));
  });
  std::uint32_t* const cell = entries.cells.data();
  std::uint32_t* const box_of_cell = entries.box_of.data();
  const std::uint64_t box_count = all.children;
  executor.for_each(all.entries, [=] MASU_PASS(std::uint64_t i) {
    const std::uint64_t box = owner_by([=](std::uint64_t b) { return boxes[b].begin; }, box_count, i);
    cell[i] = starts[boxes[box].parent_word].leaves + static_cast<std::uint32_t>(i) - boxes[box].begin;
    box_of_cell[i] = static_cast<std::uint32_t>(box);
  });
  std::uint64_t words = top_words;
  while (levels.back().boxes.size() > 0) {
    levels.push_back(divide_map_level(executor, grid.cells.data(), levels.back(), entries, grid.exceeded));
    if (grid.exceeded != nullptr) return;
    words += levels[levels.size() - 2].words.size();
    if ((grid.exceeded = exceeded_by_sizes(0, 0, top_words, words)) != nullptr) return;
  }

  const auto counts = count_words(executor, levels);
  auto begins = executor.template array<std::uint32_t>(box_count + 1);
  std::uint32_t* const begin = begins.data();
  const std::uint32_t* const count = counts[0].data();
  executor.for_each(box_count + 1,
                    [=] MASU_PASS(std::uint64_t i) { begin[i] = i == box_count ? 0 : count[i]; });
  executor.scan(begins);
  executor.for_each(box_count,
                    [=] MASU_PASS(std::uint64_t i) { begin[i] += static_cast<std::uint32_t>(top_words); });
  grid.voxel_map = executor.template zeros<std::uint32_t>(words);
  std::uint32_t* const map = grid.voxel_map.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) {
    const WordCounts here = before[i];
    map[place[i]] = leaves[i].leaves > 1 ? map_word({begin[here.children], boxes[here.children].division})
                                         : occupied_bit | starts[i].leaves;
  });
  write_maps(executor, levels, counts, std::move(begins), grid.voxel_map);
}

template <class Executor>
MergedGridView<double> merged_view(const ExecutorGrid<Executor>& grid) {
  const GridLayout finest = finer(grid.layout, grid.nested_log2);
  return {grid.voxel_map.data(), grid.cells.data(),    grid.references.data(), {}, {}, {},
          finest.division,       grid.layout.division, grid.nested_log2};
}

template <class Executor, class Stored>
ExecutorGrid<Executor> irregular_grid(Executor& executor, const SceneView<Stored>& scene,
                                      const GridLayout& layout, Overlap overlap, const GridOptions& options) {
  check_primitives(scene.primitive_count());
  const Vec3i division = layout.division;
  ExecutorGrid<Executor> grid{layout, GridKind::irregular, 0, nested_log2_for(division, options)};
  if ((grid.exceeded = exceeded_by_division(division)) != nullptr) return grid;
  const Splitter<Stored> splitter(scene, finer(layout, grid.nested_log2), overlap, options);
  auto found = voxel_pairs(executor, scene, layout, overlap, StorageOrder(division, 0));
  if (!found) {
    grid.exceeded = too_many_references;
    return grid;
  }
  VoxelPairs<Executor> pairs = std::move(*found);
  found.reset();
  OccupiedVoxels<Executor> occupied = occupied_voxels(executor, pairs);
  OpenFragments<Executor> open;
  auto first = first_level(executor, splitter, division, grid.nested_log2, pairs, occupied, open);
  pairs = {};
  occupied.numbers = {};
  auto levels = split_all(executor, splitter, std::move(first), std::move(open));

  if ((grid.exceeded = exceeded_by_leaves(levels)) != nullptr) return grid;

  // Where each voxel's cells and references go.
  const auto counts = count_leaves(executor, levels);
  const std::uint64_t voxels = occupied.places.size();
  auto occupied_numbers = executor.template zeros<std::uint32_t>(voxel_count(division));
  auto starts = executor.template array<LeafCounts>(voxels + 1);
  std::uint32_t* const occupied_number = occupied_numbers.data();
  LeafCounts* const start = starts.data();
  const LeafCounts* const leaves = counts[0].data();
  const std::uint32_t* const place = occupied.places.data();
  executor.for_each(voxels + 1, [=] MASU_PASS(std::uint64_t i) {
    start[i] = {0, i == voxels ? 0 : leaves[i].references};
    if (i != voxels) occupied_number[place[i]] = static_cast<std::uint32_t>(i) + 1;
  });
  executor.scan(starts);
  const auto cells_before = cells_before_voxels(executor, division, occupied_number, leaves);
  const std::uint32_t* const cell_before = cells_before.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) { start[i].leaves = cell_before[place[i]]; });
  const std::uint64_t cells = executor.value(cells_before, voxel_count(division)),
                      references = executor.value(starts, voxels).references;
  if ((grid.exceeded = exceeded_by_sizes(cells, references, 0, 0)) != nullptr) return grid;
  grid.cells = executor.template array<MergedCell>(cells);
  grid.references = executor.template array<PrimitiveIndex>(references);
  auto copied = executor.template array<LeafCounts>(voxels + 1);
  LeafCounts* const copy = copied.data();
  executor.for_each(voxels + 1, [=] MASU_PASS(std::uint64_t i) { copy[i] = start[i]; });
  write_leaves(executor, levels, counts, std::move(copied), grid);
  levels.clear();
  write_nested_maps(executor, division, occupied.places, start, leaves, grid);
  if (grid.exceeded != nullptr) return grid;
  write_empty_runs(executor, division, occupied_number, cell_before, grid);
  expand_cells(executor, merged_view(grid), cells, grid.cells.data(), options.expansions);
  return grid;
}

} // namespace masu
