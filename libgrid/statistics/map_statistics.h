// Where a grid's cells are: how large, how the map leads to them, and how many of them a ray is expected to
// meet.
#pragma once

#include "libgrid/grid/grid.h"
#include "libgrid/grid/grid_layout.h"

#include <span>
#include <vector>

namespace masu {

// What a random line through the space meets. It meets a box within the space with the probability of the
// box's surface area over the space's (Crofton), so cells and tests are sums over the cells' own boxes.
// Assumed: nothing stops the ray, all such lines are equally likely, and a primitive that several cells list
// is tested in each. Rays that begin or end within the scene meet less; a walk leaves expanded cells through
// the box they were expanded to, and so enters fewer cells than these.
struct ExpectedRay {
  double cells = 0; // an empty block of a uniform grid's map is one
  double tests = 0;
  double voxels_skipped = 0; // steps saved beside a walk through every smallest voxel
};

struct MapStatistics {
  std::uint64_t voxels = 0, occupied_voxels = 0; // the smallest
  std::vector<std::uint64_t> words;              // of the map by level, the top one's first
  double loads = 0;                              // of words of the map, for a random point
  ExpectedRay ray;
  // Of merged grids: cells by size, cells_by_size[n] of 2^n to 2^(n+1) - 1 voxels of their own; and how many
  // times larger expansion made their boxes, in the geometric mean over all cells, since a few cells' grow
  // beyond all others.
  std::vector<std::uint64_t> cells_by_size;
  std::uint64_t expanded_cells = 0;
  double mean_expansion = 1;
};

// Look at all that the map holds. `references` and `cells` as in grid.h.
MapStatistics map_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references);
MapStatistics map_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells);

// The voxels that lead to a cell: how many, and the box around them, which they fill in grids that gridbuild
// makes. A cell to which none leads has voxels = 0 and an unspecified box.
struct OwnVoxels {
  VoxelBox box{{largest_voxel, largest_voxel, largest_voxel}, {0, 0, 0}};
  std::uint64_t voxels = 0;

  static constexpr std::int32_t largest_voxel = 0xffff;
};

// One for each cell.
std::vector<OwnVoxels> own_voxels(const MergedGridView<double>& grid, std::span<const MergedCell> cells);
} // namespace masu
