// The cells of a grid or the boxes of a hierarchy in one form, in scene units: for pictures and for export.
#pragma once

#include "libgrid/file/structure_file.h"

#include <functional>
#include <optional>

namespace masu {

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
