// All cells of a grid one by one, uniform and merged alike: for pictures, for export, for tests.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/grid/grid.h"
#include "libgrid/grid/grid_layout.h"

#include <functional>
#include <span>

namespace masu {

struct GridCell {
  std::uint64_t number; // a merged grid's: index among its cells; a uniform grid's: linear_index of the voxel
  // In the smallest voxels. `box`: around those that lead to the cell, which fill it in grids that gridbuild
  // makes; so these boxes partition the space. `expanded`: what a ray that entered the cell leaves it
  // through; such boxes overlap.
  VoxelBox box, expanded;
  std::uint64_t voxels; // that lead to it
  std::uint32_t references;
};

// Which cells are wanted.
struct CellFilter {
  VoxelBox within{}; // cells whose box has voxels in common with it
  bool occupied_only = false;
};

inline VoxelBox whole_of(const Vec3i& division) {
  return {{0, 0, 0}, division};
}

// The layout of the smallest voxels, in the world.
GridLayout finest_layout(const StructureFile& file);

// Where a box of the layout's voxels lies. Neighbours share coordinates bit for bit, and the outermost have
// those of the space.
Boxd box_in_scene(const GridLayout& finest, const VoxelBox& box);

// The voxels that a box in scene units covers, also in part; none where it misses the space. Voxels that it
// only touches don't count.
VoxelBox voxels_covered(const GridLayout& finest, const Boxd& box);

using CellAction = std::function<void(const GridCell&)>;

// In the order of their numbers. A uniform grid's cells, which are its voxels, take no memory; a merged
// grid's take 32 bytes each. `cells` as in grid.h.
void for_each_cell(const GridView<double>& grid, const CellFilter& filter, const CellAction& act);
void for_each_cell(const MergedGridView<double>& grid, std::span<const MergedCell> cells,
                   const CellFilter& filter, const CellAction& act);
void for_each_cell(const StructureFile& file, const CellFilter& filter, const CellAction& act);

} // namespace masu
