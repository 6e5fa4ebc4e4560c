#include "libgrid/statistics/slice.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace masu {
namespace {

std::int32_t shortest_side(const VoxelBox& box) {
  const Vec3i sides = box.end - box.first;
  return std::min({sides.x, sides.y, sides.z});
}

std::int32_t floor_log2(std::int32_t value) {
  return static_cast<std::int32_t>(std::bit_width(static_cast<std::uint32_t>(value))) - 1;
}

VoxelBox voxels_of(const GridLayout& finest, const SlicePlane& plane, const SliceWindow& window) {
  Boxd box = finest.space;
  const std::array<int, 2> axes = slice_axes(plane.axis);
  for (std::size_t i = 0; i < 2; ++i) {
    box.min.set(axes[i], window.min[i]);
    box.max.set(axes[i], window.max[i]);
  }
  VoxelBox voxels = voxels_covered(finest, box);
  voxels.first.set(plane.axis, plane.layer);
  voxels.end.set(plane.axis, plane.layer + 1);
  return voxels;
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

SliceWindow window_of(const GridLayout& finest, int axis) {
  const std::array<int, 2> axes = slice_axes(axis);
  const Boxd& space = finest.space;
  return {{space.min[axes[0]], space.min[axes[1]]}, {space.max[axes[0]], space.max[axes[1]]}};
}

void for_each_slice_cell(const GridFile& file, const SlicePlane& plane, const SliceWindow& window,
                         const SliceAction& act) {
  const auto nested_log2 = static_cast<std::int32_t>(file.table().nested_log2());
  const std::array<int, 2> axes = slice_axes(plane.axis);
  for_each_cell(file, {voxels_of(finest_layout(file), plane, window)}, [&](const GridCell& cell) {
    const VoxelBox& box = cell.box;
    act({{box.first[axes[0]], box.first[axes[1]]},
         {box.end[axes[0]], box.end[axes[1]]},
         std::max(nested_log2 - floor_log2(shortest_side(box)), 0),
         cell.references,
         cell.voxels,
         cell.number});
  });
}

Slice slice_of(const GridFile& file, const SlicePlane& plane, const SliceWindow& window, const char* place,
               std::size_t most) {
  Slice slice{plane, finest_layout(file), static_cast<std::int32_t>(file.table().nested_log2()), {}};
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
    if (slice.cells.size() == most)
      throw Error(ErrorCode::usage, place,
                  fmt::format("has more than {} cells: give a smaller window", most));
    slice.cells.push_back(cell);
  });
  return slice;
}

} // namespace masu
