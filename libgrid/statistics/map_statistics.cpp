#include "libgrid/statistics/map_statistics.h"

#include "libgrid/grid/grid_layout.h"
#include "libgrid/grid/overlap/overlap.h"
#include "libgrid/statistics/statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace masu {
namespace {

// Half the surface of a box; a ratio of two is that of their surfaces.
double half_area(const Vec3d& w) {
  return w.x * w.y + w.y * w.z + w.z * w.x;
}

Vec3d extent_of(const VoxelBox& box, const Vec3d& voxel) {
  return cast<double>(box.end - box.first) * voxel;
}

// The voxels of the division that a random line meets: each plane within the space is crossed with the
// probability of its two faces over the space's surface.
double expected_voxels(const Vec3i& n, const Vec3d& voxel) {
  const Vec3d w = cast<double>(n) * voxel;
  return 1 + ((n.x - 1) * w.y * w.z + (n.y - 1) * w.z * w.x + (n.z - 1) * w.x * w.y) / half_area(w);
}

// act(word, first voxel of its box, the box's sides as powers of two, level) for each word of a merged
// grid's map that leads to something.
template <class Act>
class MapWords {
public:
  MapWords(const MergedGridView<double>& grid, const Act& act) : grid_(grid), act_(act) {}

  void visit_all() const {
    const std::int32_t log2 = grid_.nested_log2;
    for_each_voxel({{0, 0, 0}, grid_.top - Vec3i{1, 1, 1}}, [&](const Vec3i& at) {
      visit(grid_.voxel_map[linear_index(at, grid_.top)], {at.x << log2, at.y << log2, at.z << log2},
            {log2, log2, log2}, 0);
    });
  }

private:
  void visit(std::uint32_t word, const Vec3i& first, const Vec3i& sides_log2, std::size_t level) const {
    act_(word, first, sides_log2, level);
    if ((word & occupied_bit) != 0) return;
    const MapDivision division = map_division(word);
    const Vec3i n = division.log2, rest = sides_log2 - n;
    for_each_voxel({{0, 0, 0}, {(1 << n.x) - 1, (1 << n.y) - 1, (1 << n.z) - 1}}, [&](const Vec3i& part) {
      visit(grid_.voxel_map[division.offset + index_in_division(part, n)],
            {first.x + (part.x << rest.x), first.y + (part.y << rest.y), first.z + (part.z << rest.z)}, rest,
            level + 1);
    });
  }

  const MergedGridView<double>& grid_;
  const Act& act_;
};

std::uint64_t voxels_of(const Vec3i& sides_log2) {
  return std::uint64_t{1} << (sides_log2.x + sides_log2.y + sides_log2.z);
}

void include(OwnVoxels& own, const Vec3i& first, const Vec3i& sides_log2) {
  own.voxels += voxels_of(sides_log2);
  for (int axis = 0; axis < 3; ++axis) {
    own.box.first.set(axis, std::min(own.box.first[axis], first[axis]));
    own.box.end.set(axis, std::max(own.box.end[axis], first[axis] + (1 << sides_log2[axis])));
  }
}

double volume_of(const MergedCell& cell) {
  const auto extent = [](std::uint32_t range) {
    return static_cast<double>(end_of(range) - first_of(range));
  };
  return extent(cell.x) * extent(cell.y) * extent(cell.z);
}

ExpectedRay expected_ray(const MergedGridView<double>& grid, std::span<const MergedCell> cells,
                         std::span<const OwnVoxels> own) {
  const Vec3d& voxel = grid.voxel_size;
  double visited = 0, tested = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (own[i].voxels == 0) continue;
    const double area = half_area(extent_of(own[i].box, voxel));
    visited += area;
    tested += area * references_of(grid.references, cells[i].list);
  }
  const double space = half_area(cast<double>(grid.division) * voxel);
  return {visited / space, tested / space, expected_voxels(grid.division, voxel) - visited / space};
}

} // namespace

std::vector<OwnVoxels> own_voxels(const MergedGridView<double>& grid, std::span<const MergedCell> cells) {
  std::vector<OwnVoxels> own(cells.size());
  const auto add = [&](std::uint32_t word, const Vec3i& first, const Vec3i& sides_log2, std::size_t) {
    if ((word & occupied_bit) != 0) include(own[word & ~occupied_bit], first, sides_log2);
  };
  MapWords(grid, add).visit_all();
  return own;
}

MapStatistics map_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells) {
  MapStatistics statistics;
  statistics.voxels = voxel_count(grid.division);
  const auto voxels = static_cast<double>(statistics.voxels);

  double loads = 0;
  const auto count_word = [&](std::uint32_t, const Vec3i&, const Vec3i& sides_log2, std::size_t level) {
    if (level == statistics.words.size()) statistics.words.resize(level + 1, 0);
    ++statistics.words[level];
    loads += static_cast<double>(voxels_of(sides_log2)); // a sum of integers: exact
  };
  MapWords(grid, count_word).visit_all();
  statistics.loads = loads / voxels;

  const std::vector<OwnVoxels> own = own_voxels(grid, cells);
  double log_expansion = 0;
  std::uint64_t reached = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (own[i].voxels == 0) continue;
    ++reached;
    if (cells[i].list != empty_list) statistics.occupied_voxels += own[i].voxels;
    const auto size = static_cast<std::size_t>(std::bit_width(own[i].voxels)) - 1;
    if (size >= statistics.cells_by_size.size()) statistics.cells_by_size.resize(size + 1, 0);
    ++statistics.cells_by_size[size];
    const double factor = volume_of(cells[i]) / static_cast<double>(own[i].voxels);
    log_expansion += std::log(factor);
    if (factor > 1) ++statistics.expanded_cells;
  }
  statistics.mean_expansion =
      std::exp(log_expansion / static_cast<double>(std::max<std::uint64_t>(reached, 1)));
  statistics.ray = expected_ray(grid, cells, own);
  return statistics;
}

MapStatistics map_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references) {
  MapStatistics statistics;
  statistics.voxels = voxel_count(grid.division);
  statistics.occupied_voxels = static_cast<std::uint64_t>(
      std::count_if(references.begin(), references.end(), [](auto r) { return (r & last_bit) != 0; }));
  statistics.words = {voxel_count(grid.blocks)};
  const Vec3d& voxel = grid.voxel_size;
  const double space = half_area(cast<double>(grid.division) * voxel);

  std::uint64_t in_block_maps = 0;
  double skipped = 0;
  const int log2 = grid.block_log2;
  if (log2 > 0) {
    statistics.words.resize(2, 0);
    for_each_voxel({{0, 0, 0}, grid.blocks - Vec3i{1, 1, 1}}, [&](const Vec3i& block) {
      Vec3i n{};
      for (int axis = 0; axis < 3; ++axis)
        n.set(axis, std::min(1 << log2, grid.division[axis] - (block[axis] << log2)));
      if ((grid.voxel_map[linear_index(block, grid.blocks)] & occupied_bit) != 0) {
        statistics.words[1] += std::uint64_t{1} << (3 * log2);
        in_block_maps += voxel_count(n);
      } else {
        const double area = half_area(cast<double>(n) * voxel);
        skipped += (expected_voxels(n, voxel) - 1) * area / space;
      }
    });
  }
  statistics.loads = 1 + static_cast<double>(in_block_maps) / static_cast<double>(statistics.voxels);
  statistics.ray = {expected_voxels(grid.division, voxel) - skipped,
                    static_cast<double>(references.size()) * half_area(voxel) / space, skipped};
  return statistics;
}

} // namespace masu
