#include "libgrid/statistics/statistics.h"

#include "libgrid/file/structure_file.h"
#include "libgrid/structure/builder.h"

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

void describe(GridStatistics& statistics) {
  const std::vector<std::uint64_t>& histogram = statistics.histogram;
  const auto cells = static_cast<double>(statistics.occupied_cells);
  if (statistics.occupied_cells == 0) return;
  statistics.mean = static_cast<double>(statistics.references) / cells;
  double squares = 0;
  for (std::size_t n = 0; n < histogram.size(); ++n) {
    const double off = static_cast<double>(n) - statistics.mean;
    squares += off * off * static_cast<double>(histogram[n]);
  }
  statistics.stddev = std::sqrt(squares / cells);
  // The rank-th smallest, from 0.
  const auto at_rank = [&](std::uint64_t rank) {
    std::uint64_t seen = 0;
    std::size_t n = 0;
    while (n + 1 < histogram.size() && (seen += histogram[n]) <= rank)
      ++n;
    return static_cast<std::uint64_t>(n);
  };
  const std::uint64_t last = statistics.occupied_cells - 1;
  statistics.median = static_cast<double>(at_rank(last / 2) + at_rank((last + 1) / 2)) / 2;
  statistics.p99 = at_rank(static_cast<std::uint64_t>(std::ceil(0.99 * cells)) - 1);
  statistics.min = at_rank(0);
  statistics.max = histogram.size() - 1;
}

void add_cell(GridStatistics& statistics, std::uint32_t references) {
  if (references >= statistics.histogram.size()) statistics.histogram.resize(references + std::size_t{1}, 0);
  ++statistics.histogram[references];
  ++statistics.occupied_cells;
  statistics.references += references;
}

} // namespace

GridStatistics grid_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references) {
  GridStatistics statistics;
  statistics.cells = voxel_count(grid.division);
  for (std::size_t first = 0, i = 0; i < references.size(); ++i) {
    if ((references[i] & last_bit) == 0) continue;
    add_cell(statistics, static_cast<std::uint32_t>(i + 1 - first));
    first = i + 1;
  }
  describe(statistics);
  return statistics;
}

GridStatistics grid_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells) {
  GridStatistics statistics;
  statistics.cells = cells.size();
  for (const MergedCell& cell : cells) {
    if (cell.list != empty_list) add_cell(statistics, references_of(grid.references, cell.list));
  }
  describe(statistics);
  return statistics;
}

template <class Stored>
std::uint64_t occupied_voxels(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap) {
  const Structure grid = build_structure(scene, layout, overlap);
  return grid_statistics(view_of<double>(grid), grid.references).occupied_cells;
}
template std::uint64_t occupied_voxels(const SceneView<float>&, const GridLayout&, Overlap);
template std::uint64_t occupied_voxels(const SceneView<double>&, const GridLayout&, Overlap);

template <class Stored>
std::uint64_t occupied_half_open(const SceneView<Stored>& scene, const GridLayout& layout) {
  const Vec3d size = voxel_size(layout);
  std::vector<bool> occupied(voxel_count(layout.division), false);
  const auto mark = [&](const Boxd& box) {
    VoxelRange range{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto voxel = [&](double at) {
        const double number = std::floor((at - layout.space.min[axis]) / size[axis]);
        return static_cast<std::int32_t>(std::clamp(number, 0.0, layout.division[axis] - 1.0));
      };
      range.first.set(axis, voxel(box.min[axis]));
      range.last.set(axis, voxel(box.max[axis]));
    }
    for_each_voxel(range, [&](const Vec3i& voxel) { occupied[linear_index(voxel, layout.division)] = true; });
  };
  for (PrimitiveIndex i = 0; i < scene.primitive_count(); ++i)
    with_primitive(scene, i, [&](const auto& primitive) { mark(box_for_overlap(primitive)); });
  return static_cast<std::uint64_t>(std::count(occupied.begin(), occupied.end(), true));
}
template std::uint64_t occupied_half_open(const SceneView<float>&, const GridLayout&);
template std::uint64_t occupied_half_open(const SceneView<double>&, const GridLayout&);

} // namespace masu
