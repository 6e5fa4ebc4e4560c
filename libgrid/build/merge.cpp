#include "libgrid/build/merge.h"

#include "libgrid/build/expand_passes.h"
#include "libgrid/build/nested_map.h"
#include "libgrid/build/tbb_executor.h"
#include "libgrid/file/grid_file.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <numeric>

namespace masu {
namespace {

constexpr double splitting_share = 0.6; // of an irregular grid's time; the rest is expansion

// A part of a grid on its own: places and numbers in it count from its own beginning. `top` are words of the
// map's top level, `nested` what they lead to.
struct GridPart {
  std::vector<std::uint32_t> top, nested;
  std::vector<MergedCell> cells;
  std::vector<PrimitiveIndex> references;
};

void add_cells(const Partition& partition, GridPart& part) {
  for (const Leaf& leaf : partition.leaves) {
    const auto list = static_cast<std::uint32_t>(part.references.size());
    part.cells.push_back(packed(leaf.box, leaf.count > 0 ? list : empty_list));
    const auto first = partition.references.begin() + leaf.begin;
    part.references.insert(part.references.end(), first, first + leaf.count);
    if (leaf.count > 0) part.references.back() |= last_bit;
  }
}

std::vector<PrimitiveIndex> listed(const Grid& grid, std::uint32_t list) {
  std::vector<PrimitiveIndex> primitives;
  for (bool last = false; !last; ++list) {
    last = (grid.references[list] & last_bit) != 0;
    primitives.push_back(grid.references[list] & ~last_bit);
  }
  return primitives;
}

// One row along x of a uniform grid's voxels: empty ones are joined, those with primitives divided by
// `divide`(voxel's box, primitives).
template <class Divide>
GridPart row_part(const Grid& uniform, std::int32_t y, std::int32_t z, std::int32_t nested_log2,
                  const Divide& divide) {
  const GridView<double> view = view_of<double>(uniform);
  GridPart part;
  bool after_empty = false;
  for (std::int32_t x = 0; x < view.division.x; ++x) {
    const Vec3i voxel{x, y, z};
    const auto scaled = [&](const Vec3i& v) {
      return Vec3i{v.x << nested_log2, v.y << nested_log2, v.z << nested_log2};
    };
    const VoxelBox box{scaled(voxel), scaled(voxel + Vec3i{1, 1, 1})};
    const std::uint32_t word = look_up(view, voxel).word;
    if ((word & occupied_bit) == 0) {
      if (!after_empty) part.cells.push_back(packed(box, empty_list));
      MergedCell& cell = part.cells.back();
      cell.x = (cell.x & 0xffff) | static_cast<std::uint32_t>(box.end.x) << 16;
      part.top.push_back(occupied_bit | static_cast<std::uint32_t>(part.cells.size() - 1));
      after_empty = true;
      continue;
    }
    after_empty = false;
    const Partition partition = divide(box, listed(uniform, word & ~occupied_bit));
    const auto first_cell = static_cast<std::uint32_t>(part.cells.size());
    const std::size_t first_word = part.nested.size();
    const std::uint32_t root = append_nested_map(partition.leaves, box.first, nested_log2, part.nested);
    const auto moved = [&](std::uint32_t w) { return (w & occupied_bit) != 0 ? w + first_cell : w; };
    part.top.push_back(moved(root));
    std::transform(part.nested.begin() + static_cast<std::ptrdiff_t>(first_word), part.nested.end(),
                   part.nested.begin() + static_cast<std::ptrdiff_t>(first_word), moved);
    add_cells(partition, part);
  }
  return part;
}

// Where each part's words, cells and references begin in the whole; one entry more than there are parts.
template <class Size>
std::vector<std::uint64_t> offsets(const std::vector<GridPart>& parts, std::uint64_t first,
                                   const Size& size) {
  std::vector<std::uint64_t> begin{first};
  for (const GridPart& part : parts)
    begin.push_back(begin.back() + size(part));
  return begin;
}

// Puts the rows of the top level's map together, unless that would be too large: returns what exceeds.
const char* join(std::vector<GridPart>& rows, Grid& grid) {
  const auto top = offsets(rows, 0, [](const GridPart& part) { return part.top.size(); });
  const auto nested =
      offsets(rows, rounded_to_unit(top.back()), [](const GridPart& part) { return part.nested.size(); });
  const auto cells = offsets(rows, 0, [](const GridPart& part) { return part.cells.size(); });
  const auto references = offsets(rows, 0, [](const GridPart& part) { return part.references.size(); });
  if (const char* const exceeded =
          exceeded_by_sizes(cells.back(), references.back(), nested.front(), nested.back()))
    return exceeded;
  grid.voxel_map.assign(nested.back(), 0);
  grid.cells.resize(cells.back());
  grid.references.resize(references.back());
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t i) {
    GridPart& row = rows[i];
    const auto cell = static_cast<std::uint32_t>(cells[i]), place = static_cast<std::uint32_t>(nested[i]),
               list = static_cast<std::uint32_t>(references[i]);
    const auto moved = [&](std::uint32_t word) {
      if (word == 0) return word; // fills a unit up
      if ((word & occupied_bit) != 0) return word + cell;
      const MapDivision division = map_division(word);
      return map_word({division.place + place, division.log2});
    };
    std::transform(row.top.begin(), row.top.end(), grid.voxel_map.data() + top[i], moved);
    std::transform(row.nested.begin(), row.nested.end(), grid.voxel_map.data() + nested[i], moved);
    std::transform(row.cells.begin(), row.cells.end(), grid.cells.data() + cells[i], [&](MergedCell c) {
      if (c.list != empty_list) c.list += list;
      return c;
    });
    std::copy(row.references.begin(), row.references.end(), grid.references.data() + references[i]);
    row = {};
  });
  return nullptr;
}

template <class Divide>
const char* merge_rows(const Grid& uniform, Grid& grid, const std::function<void(double)>& progress,
                       const Divide& divide) {
  const Vec3i n = grid.layout.division;
  std::vector<GridPart> rows(static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z));
  std::mutex counting;
  std::size_t finished = 0;
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t row) {
    const auto y = static_cast<std::int32_t>(row % static_cast<std::size_t>(n.y)),
               z = static_cast<std::int32_t>(row / static_cast<std::size_t>(n.y));
    rows[row] = row_part(uniform, y, z, grid.nested_log2, divide);
    if (!progress) return;
    const std::lock_guard lock(counting);
    progress(static_cast<double>(++finished) / static_cast<double>(rows.size()));
  });
  return join(rows, grid);
}

template <class Stored>
const char* merge_balanced(const SceneView<Stored>& scene, Overlap overlap, const GridOptions& options,
                           Grid& grid) {
  const Vec3i n = grid.layout.division;
  std::vector<PrimitiveIndex> all(scene.primitive_count());
  std::iota(all.begin(), all.end(), 0U);
  const Partition whole = partition(scene, grid.layout, overlap, options, {{0, 0, 0}, n}, all);
  std::vector<GridPart> parts(1);
  GridPart& part = parts.front();
  add_cells(whole, part);
  part.top.resize(voxel_count(n));
  tbb::parallel_for(std::size_t{0}, whole.leaves.size(), [&](std::size_t cell) {
    const VoxelBox& box = whole.leaves[cell].box;
    for_each_voxel({box.first, box.end - Vec3i{1, 1, 1}}, [&](const Vec3i& voxel) {
      part.top[linear_index(voxel, n)] = occupied_bit | static_cast<std::uint32_t>(cell);
    });
  });
  return join(parts, grid);
}

} // namespace

const char* exceeded_by_division(const Vec3i& division) {
  const bool fits = std::max({division.x, division.y, division.z}) <= largest_plane &&
                    voxel_count(division) <= most_merged_voxels;
  return fits ? nullptr : "more than 2^28 voxels to merge";
}

const char* exceeded_by_sizes(std::uint64_t cells, std::uint64_t references, std::uint64_t top_words,
                              std::uint64_t words) {
  if (std::max(cells, references) > most_numbered) return too_many_cells;
  if (words > most_nested_words && words > top_words) return "more than 2^27 words for its map";
  return nullptr;
}

std::int32_t nested_log2_for(const Vec3i& division, const GridOptions& options) {
  const std::int32_t longest = std::max({division.x, division.y, division.z});
  std::int32_t nested_log2 = 0;
  while (nested_log2 < options.nested_log2 && (longest << (nested_log2 + 1)) <= largest_plane)
    ++nested_log2;
  return nested_log2;
}

template <class Stored>
BuildResult merged_grid(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                        const GridOptions& options, const std::function<void(double)>& progress) {
  BuildResult result{{layout, options.kind, 0, 0, {}, {}, {}}, exceeded_by_division(layout.division)};
  if (result.exceeded != nullptr) return result;
  if (options.kind == GridKind::balance) {
    check_primitives(scene.primitive_count());
    result.exceeded = merge_balanced(scene, overlap, options, result.grid);
    return result;
  }
  const BuildResult uniform = uniform_grid(scene, layout, overlap);
  if (uniform.exceeded != nullptr) return uniform;
  if (options.kind == GridKind::x) {
    result.exceeded = merge_rows(uniform.grid, result.grid, progress,
                                 [](const VoxelBox& box, std::vector<PrimitiveIndex> primitives) {
                                   const auto count = static_cast<std::uint32_t>(primitives.size());
                                   return Partition{{{box, 0, count}}, std::move(primitives)};
                                 });
    return result;
  }
  result.grid.nested_log2 = nested_log2_for(layout.division, options);
  const GridLayout finest = finer(layout, result.grid.nested_log2);
  const auto splitting = [&](double share) {
    if (progress) progress(splitting_share * share);
  };
  result.exceeded = merge_rows(uniform.grid, result.grid, splitting,
                               [&](const VoxelBox& box, const std::vector<PrimitiveIndex>& primitives) {
                                 return partition(scene, finest, overlap, options, box, primitives);
                               });
  TbbExecutor executor;
  if (result.exceeded == nullptr)
    expand_cells(executor, merged_view_of<double>(result.grid), result.grid.cells.size(),
                 result.grid.cells.data(), options.expansions);
  return result;
}
template BuildResult merged_grid(const SceneView<float>&, const GridLayout&, Overlap, const GridOptions&,
                                 const std::function<void(double)>&);
template BuildResult merged_grid(const SceneView<double>&, const GridLayout&, Overlap, const GridOptions&,
                                 const std::function<void(double)>&);

} // namespace masu
