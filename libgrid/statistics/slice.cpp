#include "libgrid/statistics/slice.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace masu {
namespace {

// The window in its plane.
Boxd box_of(const SlicePlane& plane, const SliceWindow& window) {
  Boxd box{};
  box.min.set(plane.axis, plane.position);
  box.max.set(plane.axis, plane.position);
  const std::array<int, 2> axes = slice_axes(plane.axis);
  for (std::size_t i = 0; i < 2; ++i) {
    box.min.set(axes[i], window.min[i]);
    box.max.set(axes[i], window.max[i]);
  }
  return box;
}

} // namespace

SlicePlane plane_of_layer(const GridLayout& finest, int axis, std::int64_t layer, const char* place) {
  const std::int32_t layers = finest.division[axis];
  if (layer < 0 || layer >= layers)
    throw Error(ErrorCode::usage, place,
                fmt::format("layer {} lies outside: the grid has {} along {}, from 0 on", layer, layers,
                            "xyz"[axis]));
  const auto index = static_cast<std::int32_t>(layer);
  return {axis, index, finest.space.min[axis] + (index + 0.5) * voxel_size(finest)[axis]};
}

SlicePlane plane_at(const GridLayout& finest, int axis, double position, const char* place) {
  const double low = finest.space.min[axis], high = finest.space.max[axis];
  if (!(position >= low && position <= high))
    throw Error(ErrorCode::usage, place,
                fmt::format("{} lies outside: the grid's space is from {} to {} along {}", position, low,
                            high, "xyz"[axis]));
  const double layer = std::floor((position - low) / voxel_size(finest)[axis]);
  return {axis, static_cast<std::int32_t>(std::clamp(layer, 0.0, finest.division[axis] - 1.0)), position};
}

SlicePlane plane_at_share(const GridLayout& finest, int axis, double share, const char* place) {
  const double low = finest.space.min[axis], high = finest.space.max[axis];
  return plane_at(finest, axis, share < 1 ? std::min(low + share * (high - low), high) : high, place);
}

SliceWindow window_of(const GridLayout& finest, int axis) {
  const std::array<int, 2> axes = slice_axes(axis);
  const Boxd& space = finest.space;
  return {{space.min[axes[0]], space.min[axes[1]]}, {space.max[axes[0]], space.max[axes[1]]}};
}

SliceWindow in_scene(const GridLayout& finest, int axis, const SliceCell& cell) {
  const Vec3d size = voxel_size(finest);
  SliceWindow rectangle{};
  for (std::size_t i = 0; i < 2; ++i) {
    const int along = slice_axes(axis)[i];
    rectangle.min[i] = plane_in_scene(finest, size, along, cell.first[i]);
    rectangle.max[i] = plane_in_scene(finest, size, along, cell.end[i]);
  }
  return rectangle;
}

void for_each_slice_cell(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                         const std::function<void(const SliceCell&)>& act) {
  const GridLayout finest = finest_layout(file);
  const std::array<int, 2> axes = slice_axes(plane.axis);
  if (file.is_hierarchy()) {
    const Vec3d size = voxel_size(finest);
    return for_each_box(file, {box_of(plane, window), false, window.depth}, [&](const StructureBox& box) {
      const auto corner = [&](const Vec3d& at) {
        const auto share = [&](int axis) { return (at[axis] - finest.space.min[axis]) / size[axis]; };
        return std::array<double, 2>{share(axes[0]), share(axes[1])};
      };
      act({corner(box.box.min), corner(box.box.max), box.depth, box.references, box.voxels, box.number});
    });
  }
  VoxelBox voxels = voxels_covered(finest, box_of(plane, window));
  voxels.first.set(plane.axis, plane.layer);
  voxels.end.set(plane.axis, plane.layer + 1);
  for_each_cell(file, {voxels}, [&](const GridCell& cell) {
    const VoxelBox& box = cell.box;
    const std::int32_t depth = cell_depth(file, box);
    if (window.depth && depth != *window.depth) return;
    const auto corner = [&](const Vec3i& voxel) {
      return std::array<double, 2>{static_cast<double>(voxel[axes[0]]), static_cast<double>(voxel[axes[1]])};
    };
    act({corner(box.first), corner(box.end), depth, cell.references, cell.voxels, cell.number});
  });
}

} // namespace masu
