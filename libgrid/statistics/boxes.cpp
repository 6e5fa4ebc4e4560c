#include "libgrid/statistics/boxes.h"

#include "libgrid/statistics/cells.h"
#include "libgrid/statistics/hierarchy_statistics.h"
#include "libscene/local_origin.h"

#include <algorithm>
#include <bit>

namespace masu {
namespace {

bool touch(const Boxd& a, const Boxd& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::max(a.min[axis], b.min[axis]) > std::min(a.max[axis], b.max[axis])) return false;
  return true;
}

} // namespace

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
