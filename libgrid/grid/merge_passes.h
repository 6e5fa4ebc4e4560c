// Building a grid whose cells are boxes of several voxels, on whatever executor (executor.h):
//
//   1. pairs   of a voxel and a primitive in it, sorted by voxel (uniform_passes.h)
//   2. split   the occupied voxels into cells (split_passes.h)
//   3. map     from the smallest voxels to their cells (nested_map.h); empty voxels in a run along x are one
//   4. expand  cells over their neighbours (expand_passes.h)
//
// That is an irregular grid. Kind x leaves out 4, and its voxels aren't split. Kind balance splits the whole
// space as if it were one voxel.
//
// A device takes all voxels through 2 and 3 at once. The host takes part after part of them, so small that a
// core's cache holds what the passes write (merge.cpp).
#pragma once

#include "libgrid/grid/expand_passes.h"
#include "libgrid/grid/nested_map.h"
#include "libgrid/grid/split_passes.h"

namespace masu {

// Voxels of a division by their index, x fastest: whole rows along x. And the pairs of an index and a
// primitive of these, in rising order.
struct VoxelSpan {
  std::uint64_t first, end;
  const std::uint64_t* indices;
  const PrimitiveIndex* primitives;
  std::uint64_t pairs;

  MASU_HD std::uint64_t size() const { return end - first; }
};

// The voxels that hold something: which, and which pairs.
template <class Executor>
struct OccupiedVoxels {
  ArrayOf<Executor, std::uint32_t> indices{}; // in rising order
  ArrayOf<Executor, std::uint32_t> begins{};  // one more than there are voxels
  ArrayOf<Executor, std::uint32_t> numbers{}; // of each pair: how many voxels begin before it
};

template <class Executor>
OccupiedVoxels<Executor> occupied_voxels(Executor& executor, const VoxelSpan& voxels) {
  const std::uint64_t count = voxels.pairs;
  const std::uint64_t* const index = voxels.indices;
  OccupiedVoxels<Executor> occupied;
  occupied.numbers = sums_before(
      executor, count, [=] MASU_PASS(std::uint64_t i) { return i == 0 || index[i] != index[i - 1]; });
  const std::uint32_t occupied_count = executor.value(occupied.numbers, count);
  occupied.indices = executor.template array<std::uint32_t>(occupied_count);
  occupied.begins = executor.template array<std::uint32_t>(std::uint64_t{occupied_count} + 1);
  const std::uint32_t* const number = occupied.numbers.data();
  std::uint32_t* const voxel_index = occupied.indices.data();
  std::uint32_t* const begin = occupied.begins.data();
  executor.for_each(count + 1, [=] MASU_PASS(std::uint64_t i) {
    if (i == count) begin[occupied_count] = static_cast<std::uint32_t>(count);
    if (i == count || number[i + 1] == number[i]) return;
    voxel_index[number[i]] = static_cast<std::uint32_t>(index[i]);
    begin[number[i]] = static_cast<std::uint32_t>(i);
  });
  return occupied;
}

MASU_HD inline Vec3i voxel_of(std::uint64_t index, const Vec3i& division) {
  const auto x = static_cast<std::uint32_t>(division.x), y = static_cast<std::uint32_t>(division.y),
             i = static_cast<std::uint32_t>(index);
  return {static_cast<std::int32_t>(i % x), static_cast<std::int32_t>(i / x % y),
          static_cast<std::int32_t>(i / x / y)};
}

// Voxels first … end - 1, in voxels 2^log2 times smaller.
MASU_HD inline VoxelBox nested_box(const Vec3i& first, const Vec3i& end, std::int32_t log2) {
  return {{first.x << log2, first.y << log2, first.z << log2}, {end.x << log2, end.y << log2, end.z << log2}};
}
MASU_HD inline VoxelBox nested_box(const Vec3i& voxel, std::int32_t log2) {
  return nested_box(voxel, voxel + Vec3i{1, 1, 1}, log2);
}

// The fragments that fragment_of(i, fragment) makes for i = 0 … count - 1, where it is true. kept_before[i]
// is how many those before i have.
template <class Executor, class FragmentOf>
ArrayOf<Executor, Fragment> fragments_of(Executor& executor, std::uint64_t count,
                                         const FragmentOf& fragment_of,
                                         ArrayOf<Executor, std::uint32_t>& kept) {
  auto all = executor.template array<Fragment>(count);
  Fragment* const fragment = all.data();
  kept = sums_before(executor, count, [=] MASU_PASS(std::uint64_t i) { return fragment_of(i, fragment[i]); });
  const std::uint32_t* const kept_before = kept.data();
  auto fragments = executor.template array<Fragment>(executor.value(kept, count));
  Fragment* const kept_fragment = fragments.data();
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    if (kept_before[i + 1] != kept_before[i]) kept_fragment[kept_before[i]] = fragment[i];
  });
  return fragments;
}

// The occupied voxels, split into cells.
template <class Executor, class Stored>
std::vector<SplitLevel<Executor>> split_voxels(Executor& executor, const Splitter<Stored>& splitter,
                                               const Vec3i& division, std::int32_t nested_log2,
                                               const VoxelSpan& span,
                                               const OccupiedVoxels<Executor>& occupied, FragmentSum& sum) {
  const std::uint64_t voxels = occupied.indices.size();
  const std::uint32_t *const index = occupied.indices.data(), *const begin = occupied.begins.data(),
                             *const number = occupied.numbers.data();
  const auto box_of_voxel = [=] MASU_PASS(std::uint64_t i) {
    return nested_box(voxel_of(index[i], division), nested_log2);
  };
  ArrayOf<Executor, std::uint32_t> kept{};
  auto fragments = fragments_of(
      executor, span.pairs,
      [=] MASU_PASS(std::uint64_t i, Fragment & fragment) {
        return splitter.fragment_in(box_of_voxel(number[i + 1] - 1), span.primitives[i], fragment);
      },
      kept);
  SplitLevel<Executor> level{executor.template array<LevelBox>(voxels), {}};
  LevelBox* const boxes = level.boxes.data();
  const std::uint32_t* const kept_before = kept.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) {
    boxes[i] = open_box(box_of_voxel(i), kept_before[begin[i]], kept_before[begin[i + 1]]);
  });
  return split_all(executor, splitter, std::move(level), std::move(fragments), sum);
}

// The occupied voxels as cells.
template <class Executor>
std::vector<SplitLevel<Executor>> unsplit_voxels(Executor& executor, const Vec3i& division,
                                                 const VoxelSpan& span,
                                                 const OccupiedVoxels<Executor>& occupied) {
  std::vector<SplitLevel<Executor>> levels(2);
  levels[0].boxes = executor.template array<LevelBox>(occupied.indices.size());
  levels[0].listed = executor.template array<PrimitiveIndex>(span.pairs);
  LevelBox* const boxes = levels[0].boxes.data();
  PrimitiveIndex* const listed = levels[0].listed.data();
  const std::uint32_t *const index = occupied.indices.data(), *const begin = occupied.begins.data();
  executor.for_each(occupied.indices.size(), [=] MASU_PASS(std::uint64_t i) {
    boxes[i] = open_box(nested_box(voxel_of(index[i], division), 0), begin[i], begin[i + 1]);
  });
  executor.for_each(span.pairs, [=] MASU_PASS(std::uint64_t i) { listed[i] = span.primitives[i]; });
  return levels;
}

// The cells of runs of empty voxels, and the words of their voxels.
template <class Executor>
void write_empty_runs(Executor& executor, const Vec3i& division, const VoxelSpan& span,
                      const std::uint32_t* occupied_number, const std::uint32_t* cells_before,
                      ExecutorStructure<Executor>& grid) {
  MergedCell* const cells = grid.cells.data();
  std::uint32_t* const map = grid.voxel_map.data();
  const std::int32_t log2 = grid.nested_log2;
  executor.for_each(span.size(), [=] MASU_PASS(std::uint64_t i) {
    if (occupied_number[i] != 0) return;
    const bool begins = cells_before[i + 1] != cells_before[i];
    const std::uint32_t cell = begins ? cells_before[i] : cells_before[i] - 1;
    map[i] = occupied_bit | cell;
    if (!begins) return;
    const Vec3i first = voxel_of(span.first + i, division);
    Vec3i end = first + Vec3i{1, 1, 1};
    while (end.x < division.x && occupied_number[i + static_cast<std::uint32_t>(end.x - first.x)] == 0)
      ++end.x;
    cells[cell] = packed(nested_box(first, end, log2), empty_list);
  });
}

// The entries of voxels of several cells.
struct ListCells {
  using Scratch = NoScratch;
  const LeafCounts *starts, *leaves;
  const WordCounts* before;
  std::uint32_t *cells, *box_of;

  MASU_HD std::uint32_t size(std::uint64_t i) const { return leaves[i].leaves > 1 ? leaves[i].leaves : 0; }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    for (std::uint32_t cell = group.thread_rank(); cell < size(i); cell += group.size()) {
      cells[before[i].entries + cell] = starts[i].leaves + cell;
      box_of[before[i].entries + cell] = before[i].children;
    }
  }
};

// The maps of the occupied voxels, cubes of the nested division. Makes the grid's map as large as it has to
// be, unless it has too many words. `starts` and `leaves` say of each voxel where its cells begin, and how
// many they are.
template <class Executor>
void write_nested_maps(Executor& executor, const Vec3i& division, const VoxelSpan& span,
                       const ArrayOf<Executor, std::uint32_t>& indices, const LeafCounts* starts,
                       const LeafCounts* leaves, std::uint64_t max_words, ExecutorStructure<Executor>& grid) {
  const std::uint64_t voxels = indices.size(), top_words = rounded_to_unit(span.size());
  const std::uint32_t* const index = indices.data();
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
    const Vec3i voxel = voxel_of(index[i], division);
    const MapRegion cube{nested_box(voxel, log2).first, {log2, log2, log2}};
    boxes[here.children] = undivided(cube, here.entries, after.entries, static_cast<std::uint32_t>(i));
  });
  const std::uint64_t box_count = all.children;
  executor.for_each_by_group(voxels,
                             ListCells{starts, leaves, before, entries.cells.data(), entries.box_of.data()});
  std::uint64_t words = top_words;
  while (levels.back().boxes.size() > 0) {
    levels.push_back(divide_map_level(executor, grid.cells.data(), levels.back(), entries, grid.exceeded));
    if (grid.exceeded != nullptr) return;
    words += levels[levels.size() - 2].words.size();
    if ((grid.exceeded = exceeded_by_sizes(0, 0, top_words, words, max_words)) != nullptr) return;
  }

  const auto counts = count_words(executor, levels);
  const std::uint32_t* const count = counts[0].data();
  auto begins = sums_before(executor, box_count, [=] MASU_PASS(std::uint64_t i) { return count[i]; });
  std::uint32_t* const begin = begins.data();
  executor.for_each(box_count,
                    [=] MASU_PASS(std::uint64_t i) { begin[i] += static_cast<std::uint32_t>(top_words); });
  grid.voxel_map = executor.template zeros<std::uint32_t>(words);
  std::uint32_t* const map = grid.voxel_map.data();
  executor.for_each(voxels, [=] MASU_PASS(std::uint64_t i) {
    const WordCounts here = before[i];
    map[index[i] - span.first] = leaves[i].leaves > 1
                                     ? map_word({begin[here.children], boxes[here.children].division})
                                     : occupied_bit | starts[i].leaves;
  });
  write_maps(executor, levels, counts, std::move(begins), grid.voxel_map);
}

// A part of a grid whose cells, references and words are numbered from its own beginning: the words are those
// of the span's voxels, and what they lead to.
template <class Executor, class Stored>
ExecutorStructure<Executor> merged_part(Executor& executor, const Splitter<Stored>& splitter,
                                        const GridLayout& layout, std::int32_t nested_log2,
                                        const VoxelSpan& span, FragmentSum& sum) {
  const Vec3i division = layout.division;
  const StructureKind kind = splitter.options.kind;
  ExecutorStructure<Executor> grid{layout, kind, 0, nested_log2};
  OccupiedVoxels<Executor> occupied = occupied_voxels(executor, span);
  auto levels = kind == StructureKind::x
                    ? unsplit_voxels(executor, division, span, occupied)
                    : split_voxels(executor, splitter, division, nested_log2, span, occupied, sum);
  occupied.numbers = {};
  if ((grid.exceeded = exceeded_by_leaves(levels)) != nullptr) return grid;

  // Where each voxel's cells and references go.
  const auto counts = count_leaves(executor, levels);
  const std::uint64_t voxels = occupied.indices.size();
  auto occupied_numbers = executor.template zeros<std::uint32_t>(span.size());
  auto starts = executor.template array<LeafCounts>(voxels + 1);
  std::uint32_t* const occupied_number = occupied_numbers.data();
  LeafCounts* const start = starts.data();
  const LeafCounts* const leaves = counts[0].data();
  const std::uint32_t* const index = occupied.indices.data();
  executor.for_each(voxels + 1, [=] MASU_PASS(std::uint64_t i) {
    start[i] = {0, i == voxels ? 0 : leaves[i].references};
    if (i != voxels) occupied_number[index[i] - span.first] = static_cast<std::uint32_t>(i) + 1;
  });
  executor.scan(starts);
  // Those of the occupied voxels, and one for each run along x of those that hold nothing.
  const auto row = static_cast<std::uint32_t>(division.x);
  const auto cells_before = sums_before(executor, span.size(), [=] MASU_PASS(std::uint64_t i) {
    if (occupied_number[i] != 0) return leaves[occupied_number[i] - 1].leaves;
    return (span.first + i) % row == 0 || occupied_number[i - 1] != 0 ? 1U : 0U;
  });
  const std::uint32_t* const cell_before = cells_before.data();
  executor.for_each(voxels,
                    [=] MASU_PASS(std::uint64_t i) { start[i].leaves = cell_before[index[i] - span.first]; });
  const std::uint64_t cells = executor.value(cells_before, span.size()),
                      references = executor.value(starts, voxels).references;
  if ((grid.exceeded = exceeded_by_sizes(cells, references, 0, 0)) != nullptr) return grid;
  grid.cells = executor.template array<MergedCell>(cells);
  grid.references = executor.template array<PrimitiveIndex>(references);
  write_leaves(executor, levels, counts, start, grid);
  levels.clear();
  write_nested_maps(executor, division, span, occupied.indices, start, leaves, splitter.options.max_map_words,
                    grid);
  if (grid.exceeded != nullptr) return grid;
  write_empty_runs(executor, division, span, occupied_number, cell_before, grid);
  return grid;
}

// All voxels as one part. On the host's cores: as many (merge.cpp).
template <class Executor, class BuildPart>
ExecutorStructure<Executor> build_in_parts(Executor& executor, const GridLayout&, const VoxelSpan& all,
                                           std::uint64_t, const BuildPart& build_part) {
  return build_part(executor, all);
}

// Writes the words of a cell's voxels, row by row.
struct WriteVoxels {
  using Scratch = NoScratch;
  const MergedCell* cells;
  Vec3i division;
  std::uint32_t* map;

  MASU_HD std::uint32_t size(std::uint64_t i) const {
    const VoxelBox box = box_of(cells[i]);
    return static_cast<std::uint32_t>((box.end.y - box.first.y) * (box.end.z - box.first.z));
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, NoScratch&, std::uint64_t i) const {
    const VoxelBox box = box_of(cells[i]);
    const auto width = static_cast<std::uint32_t>(box.end.y - box.first.y);
    for (std::uint32_t row = group.thread_rank(); row < size(i); row += group.size()) {
      const Vec3i offset{0, static_cast<std::int32_t>(row % width), static_cast<std::int32_t>(row / width)};
      const std::uint64_t begin = linear_index(box.first + offset, division);
      for (std::int32_t x = 0; x < box.end.x - box.first.x; ++x)
        map[begin + static_cast<std::uint32_t>(x)] = occupied_bit | static_cast<std::uint32_t>(i);
    }
  }
};

template <class Executor, class Stored>
ExecutorStructure<Executor> balanced_grid(Executor& executor, const Splitter<Stored>& splitter) {
  ExecutorStructure<Executor> grid{splitter.layout, StructureKind::balance};
  const VoxelBox whole{{0, 0, 0}, grid.layout.division};
  ArrayOf<Executor, std::uint32_t> kept{};
  auto fragments = fragments_of(
      executor, splitter.scene.primitive_count(),
      [=] MASU_PASS(std::uint64_t i, Fragment & fragment) {
        return splitter.fragment_in(whole, static_cast<PrimitiveIndex>(i), fragment);
      },
      kept);
  SplitLevel<Executor> level{executor.template array<LevelBox>(1), {}};
  LevelBox* const box = level.boxes.data();
  const auto count = static_cast<std::uint32_t>(fragments.size());
  executor.for_each(1, [=] MASU_PASS(std::uint64_t i) { box[i] = open_box(whole, 0, count); });
  FragmentSum sum = 0;
  const auto levels = split_all(executor, splitter, std::move(level), std::move(fragments), sum);
  if ((grid.exceeded = exceeded_by_leaves(levels)) != nullptr) return grid;

  const auto counts = count_leaves(executor, levels);
  const LeafCounts all = executor.value(counts[0], 0);
  grid.cells = executor.template array<MergedCell>(all.leaves);
  grid.references = executor.template array<PrimitiveIndex>(all.references);
  write_leaves(executor, levels, counts, executor.template zeros<LeafCounts>(1).data(), grid);
  grid.voxel_map = executor.template zeros<std::uint32_t>(rounded_to_unit(voxel_count(grid.layout.division)));
  executor.for_each_by_group(all.leaves,
                             WriteVoxels{grid.cells.data(), grid.layout.division, grid.voxel_map.data()});
  return grid;
}

// Of kind x, balance or irregular.
template <class Executor, class Stored>
ExecutorStructure<Executor> merged_grid(Executor& executor, const SceneView<Stored>& scene,
                                        const GridLayout& layout, Overlap overlap,
                                        const StructureOptions& options) {
  check_primitives(scene.primitive_count());
  const bool irregular = options.kind == StructureKind::irregular;
  const std::int32_t longest = std::max({layout.division.x, layout.division.y, layout.division.z}),
                     nested_log2 = irregular ? nested_log2_for(longest, options) : 0;
  ExecutorStructure<Executor> grid{layout, options.kind, 0, nested_log2};
  constexpr std::uint64_t most_voxels = std::uint64_t{1} << 28; // each has a word of the map
  if (longest > max_plane || voxel_count(layout.division) > most_voxels) {
    grid.exceeded = "more than 2^28 voxels to merge";
    return grid;
  }
  StructureOptions tried = options;
  const auto splitter = [&] { return Splitter<Stored>(scene, finer(layout, nested_log2), overlap, tried); };
  if (options.kind == StructureKind::balance) return balanced_grid(executor, splitter());
  auto pairs =
      voxel_pairs(executor, scene, layout, overlap, StorageOrder(layout.division, 0), options.max_references);
  if (!pairs) {
    grid.exceeded = too_many_references;
    return grid;
  }
  const VoxelSpan all{0, voxel_count(layout.division), pairs->keys.data(), pairs->values.data(),
                      pairs->keys.size()};
  for (;; tried.detail /= 2) {
    FragmentSum sum = 0;
    grid = {};
    grid = build_in_parts(executor, layout, all, options.max_map_words,
                          [&](auto& part_executor, const VoxelSpan& span) {
                            return merged_part(part_executor, splitter(), layout, nested_log2, span, sum);
                          });
    if (grid.exceeded == nullptr || !irregular || tried.detail < 2 * options.least_detail) break;
  }
  if (irregular) grid.detail = tried.detail;
  pairs.reset();
  if (grid.exceeded == nullptr && irregular)
    expand_cells(executor, merged_view_of<double>(grid), grid.cells.size(), grid.cells.data(),
                 options.expand);
  return grid;
}

} // namespace masu
