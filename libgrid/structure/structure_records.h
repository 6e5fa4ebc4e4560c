// The records of a grid or a hierarchy, and the views of them by which they are traced.
#pragma once

#include "libgrid/grid/grid.h"
#include "libgrid/grid/grid_layout.h"
#include "libgrid/hierarchy/hierarchy.h"

namespace masu {

// The arrays, in whatever memory, and what a file's table says of them.
struct StructureRecords {
  const std::uint32_t* voxel_map;
  const MergedCell* cells;
  const PrimitiveIndex* references;
  const HierarchyNode* nodes;
  std::uint64_t words, cell_count, reference_count, node_count;
  std::uint64_t primitives; // of the scene
  bool is_hierarchy, is_merged;
  GridLayout layout; // of a merged grid that of the map's top level
  std::int32_t block_log2, nested_log2;
};

// Of a uniform grid, of a merged one, of a hierarchy. Real is the arithmetic's type.
template <class Real>
GridView<Real> view_of(const StructureRecords& grid) {
  const Vec3d size = voxel_size(grid.layout);
  return {grid.voxel_map,
          grid.references,
          cast<Real>(grid.layout.space.min),
          cast<Real>(size),
          cast<Real>(Vec3d{1 / size.x, 1 / size.y, 1 / size.z}),
          grid.layout.division,
          blocks_of(grid.layout.division, grid.block_log2),
          grid.block_log2};
}
template <class Real>
MergedGridView<Real> merged_view_of(const StructureRecords& grid) {
  const GridLayout finest = finer(grid.layout, grid.nested_log2);
  const Vec3d size = voxel_size(finest);
  return {grid.voxel_map,   grid.cells,
          grid.references,  cast<Real>(finest.space.min),
          cast<Real>(size), cast<Real>(Vec3d{1 / size.x, 1 / size.y, 1 / size.z}),
          finest.division,  grid.layout.division,
          grid.nested_log2};
}
template <class Real>
HierarchyView<Real> hierarchy_view_of(const StructureRecords& grid) {
  return {grid.nodes, grid.references};
}

// Calls act(the view of the type for the kind of grid).
template <class Real, class Act>
void with_structure_view(const StructureRecords& grid, const Act& act) {
  if (grid.is_hierarchy) return act(hierarchy_view_of<Real>(grid));
  grid.is_merged ? act(merged_view_of<Real>(grid)) : act(view_of<Real>(grid));
}

} // namespace masu
