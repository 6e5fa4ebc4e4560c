// All cells of a grid one by one, uniform and merged alike, and in one form with the boxes of a hierarchy:
// for pictures, for export, for tests.
#pragma once

#include "libgrid/file/structure_file.h"

#include <functional>
#include <optional>

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

// Where the plane before a voxel of that number is, of voxels of that size.
inline double plane_in_scene(const GridLayout& finest, const Vec3d& size, int axis, double number) {
  return number == finest.division[axis] ? finest.space.max[axis]
                                         : finest.space.min[axis] + number * size[axis];
}
// Where a box of the layout's voxels lies. Neighbours share coordinates bit for bit, and the outermost have
// those of the space.
Boxd box_in_scene(const GridLayout& finest, const VoxelBox& box);

// The voxels that a box in scene units covers, also in part; none where it misses the space. Voxels that it
// only touches don't count.
VoxelBox voxels_covered(const GridLayout& finest, const Boxd& box);

// In the order of their numbers. A uniform grid's cells, which are its voxels, take no memory; a merged
// grid's take 32 bytes each.
void for_each_cell(const StructureFile& file, const CellFilter& filter,
                   const std::function<void(const GridCell&)>& act);

// A cell of a grid or a box of a hierarchy, in scene units.
struct StructureBox {
  // Of a cell as in GridCell; of a hierarchy's box boxes_per_node times its node's index, and its slot.
  std::uint64_t number;
  Boxd box, expanded;       // expanded: as in GridCell; of a hierarchy the same
  std::uint32_t references; // of a box around a node 0
  std::uint64_t voxels;     // as in GridCell; of a hierarchy HierarchyBox::inner
  std::int32_t depth;       // cell_depth(); of a hierarchy that of the box's node, of the root 0
};

// Which are wanted.
struct BoxFilter {
  std::optional<Boxd> within{}; // those that share space with it; of a hierarchy also those that touch it
  bool occupied_only = false;   // those that list references
  std::optional<std::int32_t> depth{};
};

// How often a voxel of the division is halved down to the shortest side of a cell, whose box is in the
// smallest voxels; 0 for cells of whole voxels.
std::int32_t cell_depth(const StructureFile& file, const VoxelBox& box);

// The greatest depth that a box can have; of a hierarchy that its deepest has.
std::int32_t greatest_depth(const StructureFile& file);

// In the order of their numbers. A hierarchy's boxes lie in those around their nodes, which come before them.
void for_each_box(const StructureFile& file, const BoxFilter& filter,
                  const std::function<void(const StructureBox&)>& act);

} // namespace masu
