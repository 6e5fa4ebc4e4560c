#include "libgrid/statistics/cells.h"

#include "libgrid/statistics/statistics.h"
#include "libscene/local_origin.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace masu {
namespace {

bool meet(const VoxelBox& a, const VoxelBox& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(a.first[axis], b.first[axis]) >= std::min(a.end[axis], b.end[axis])) return false;
  }
  return true;
}

bool touch(const Boxd& a, const Boxd& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::max(a.min[axis], b.min[axis]) > std::min(a.max[axis], b.max[axis])) return false;
  return true;
}

void for_each_cell(const GridView<double>& grid, const CellFilter& filter,
                   const std::function<void(const GridCell&)>& act) {
  VoxelBox range{};
  for (int axis = 0; axis < 3; ++axis) {
    range.first.set(axis, std::max(filter.within.first[axis], 0));
    range.end.set(axis, std::min(filter.within.end[axis], grid.division[axis]));
  }
  for (Vec3i at{0, 0, range.first.z}; at.z < range.end.z; ++at.z) {
    for (at.y = range.first.y; at.y < range.end.y; ++at.y) {
      for (at.x = range.first.x; at.x < range.end.x;) {
        const MapEntry entry = look_up(grid, at);
        const bool is_occupied = (entry.word & occupied_bit) != 0;
        if (!is_occupied && filter.occupied_only) { // the rest of an empty block at once
          at.x = ((at.x >> entry.side_log2) + 1) << entry.side_log2;
          continue;
        }
        const std::uint32_t references =
            is_occupied ? references_of(grid.references, entry.word & ~occupied_bit) : 0;
        const VoxelBox box{at, at + Vec3i{1, 1, 1}};
        act({linear_index(at, grid.division), box, box, 1, references});
        ++at.x;
      }
    }
  }
}

void for_each_cell(const MergedGridView<double>& grid, std::span<const MergedCell> cells,
                   const CellFilter& filter, const std::function<void(const GridCell&)>& act) {
  const std::vector<OwnVoxels> own = own_voxels(grid, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (own[i].voxels == 0 || !meet(own[i].box, filter.within)) continue;
    const std::uint32_t references = references_of(grid.references, cells[i].list);
    if (references > 0 || !filter.occupied_only)
      act({i, own[i].box, box_of(cells[i]), own[i].voxels, references});
  }
}

} // namespace

GridLayout finest_layout(const StructureFile& file) {
  GridLayout finest = finer(file.layout(), static_cast<std::int32_t>(file.table().nested_log2()));
  finest.space = in_world(file.origin(), finest.space);
  return finest;
}

Boxd box_in_scene(const GridLayout& finest, const VoxelBox& box) {
  const Vec3d size = voxel_size(finest);
  Boxd result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.min.set(axis, plane_in_scene(finest, size, axis, box.first[axis]));
    result.max.set(axis, plane_in_scene(finest, size, axis, box.end[axis]));
  }
  return result;
}

VoxelBox voxels_covered(const GridLayout& finest, const Boxd& box) {
  const Vec3d size = voxel_size(finest);
  VoxelBox voxels{};
  for (int axis = 0; axis < 3; ++axis) {
    const double last = finest.division[axis];
    const auto offset = [&](double at) { return (at - finest.space.min[axis]) / size[axis]; };
    voxels.first.set(axis,
                     static_cast<std::int32_t>(std::clamp(std::floor(offset(box.min[axis])), 0.0, last)));
    voxels.end.set(axis, static_cast<std::int32_t>(std::clamp(std::ceil(offset(box.max[axis])), 0.0, last)));
  }
  return voxels;
}

void for_each_cell(const StructureFile& file, const CellFilter& filter,
                   const std::function<void(const GridCell&)>& act) {
  if (!file.is_merged()) return for_each_cell(view_of<double>(file.records()), filter, act);
  for_each_cell(merged_view_of<double>(file.records()), file.cells(), filter, act);
}

std::int32_t cell_depth(const StructureFile& file, const VoxelBox& box) {
  const Vec3i sides = box.end - box.first;
  const auto shortest = static_cast<std::uint32_t>(std::min({sides.x, sides.y, sides.z}));
  const int log2 = static_cast<int>(std::bit_width(shortest)) - 1;
  return std::max(static_cast<int>(file.table().nested_log2()) - log2, 0);
}

std::int32_t greatest_depth(const StructureFile& file) {
  return file.is_hierarchy() ? hierarchy_statistics(file.nodes()).depth - 1
                             : static_cast<std::int32_t>(file.table().nested_log2());
}

void for_each_box(const StructureFile& file, const BoxFilter& filter,
                  const std::function<void(const StructureBox&)>& act) {
  const auto is_wanted = [&](std::int32_t depth) { return !filter.depth || *filter.depth == depth; };
  if (file.is_hierarchy()) {
    const auto nodes = file.nodes();
    return for_each_box(nodes, [&](const HierarchyBox& found) {
      if ((filter.occupied_only && found.references == 0) || !is_wanted(found.depth)) return;
      const Boxd box = in_world(file.origin(), box_of(nodes[found.node], found.slot));
      if (filter.within && !touch(box, *filter.within)) return;
      const std::uint64_t number =
          std::uint64_t{found.node} * boxes_per_node + static_cast<unsigned>(found.slot);
      act({number, box, box, found.references, found.inner, found.depth});
    });
  }
  const GridLayout finest = finest_layout(file);
  const VoxelBox within = filter.within ? voxels_covered(finest, *filter.within) : whole_of(finest.division);
  for_each_cell(file, {within, filter.occupied_only}, [&](const GridCell& cell) {
    const std::int32_t depth = cell_depth(file, cell.box);
    if (is_wanted(depth))
      act({cell.number, box_in_scene(finest, cell.box), box_in_scene(finest, cell.expanded), cell.references,
           cell.voxels, depth});
  });
}

} // namespace masu
