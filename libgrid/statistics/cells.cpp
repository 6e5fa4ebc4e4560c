#include "libgrid/statistics/cells.h"

#include "libgrid/statistics/map_statistics.h"
#include "libgrid/statistics/statistics.h"
#include "libscene/local_origin.h"

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

bool meet(const VoxelBox& a, const VoxelBox& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(a.first[axis], b.first[axis]) >= std::min(a.end[axis], b.end[axis])) return false;
  }
  return true;
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
    const auto plane = [&](std::int32_t index) {
      return index == finest.division[axis] ? finest.space.max[axis]
                                            : finest.space.min[axis] + index * size[axis];
    };
    result.min.set(axis, plane(box.first[axis]));
    result.max.set(axis, plane(box.end[axis]));
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

void for_each_cell(const GridView<double>& grid, const CellFilter& filter, const CellAction& act) {
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
                   const CellFilter& filter, const CellAction& act) {
  const std::vector<OwnVoxels> own = own_voxels(grid, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (own[i].voxels == 0 || !meet(own[i].box, filter.within)) continue;
    const std::uint32_t references = references_of(grid.references, cells[i].list);
    if (references > 0 || !filter.occupied_only)
      act({i, own[i].box, box_of(cells[i]), own[i].voxels, references});
  }
}

void for_each_cell(const StructureFile& file, const CellFilter& filter, const CellAction& act) {
  if (file.is_merged())
    for_each_cell(file.merged_view<double>(), file.cells(), filter, act);
  else
    for_each_cell(file.view<double>(), filter, act);
}

} // namespace masu
