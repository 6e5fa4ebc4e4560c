// A grid file's records.
#pragma once

#include "libgrid/trace/grid_view.h"
#include "libgrid/trace/hierarchy_view.h"

namespace masu {

// Its arrays, in whatever memory, and what the file's table says of them.
struct GridRecords {
  const std::uint32_t* voxel_map;
  const MergedCell* cells;
  const PrimitiveIndex* references;
  const HierarchyNode* nodes;
  std::uint64_t words, cell_count, reference_count, node_count;
  std::uint64_t primitives; // of the scene
  bool is_hierarchy, is_merged;
  Vec3i division; // the top level's of a merged grid
  std::int32_t block_log2, nested_log2;
};

} // namespace masu
