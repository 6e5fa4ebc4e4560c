// A plane through a grid or a hierarchy, perpendicular to an axis: the rectangles in which it cuts the cells
// or boxes.
#pragma once

#include "libgrid/statistics/cells.h"

#include <array>
#include <optional>

namespace masu {

// A plane perpendicular to `axis` (0 to 2). `layer`: of the smallest voxels, the one that it goes through,
// or that lies above it where it is the face between two. `position`: in scene units.
struct SlicePlane {
  int axis;
  std::int32_t layer;
  double position;
};

// What is shown of it. In scene units, along the two axes of slice_axes().
struct SliceWindow {
  std::array<double, 2> min{}, max{};
  std::optional<std::int32_t> depth{}; // of cells; none: of any
};

// A cell, or a box of a hierarchy. In the smallest voxels along slice_axes(), from `first` to `end`: whole
// numbers of a grid; the space of a hierarchy is one voxel, and its boxes are rounded outwards, also beyond
// it.
struct SliceCell {
  std::array<double, 2> first, end;
  // As in StructureBox.
  std::int32_t depth;
  std::uint32_t references;
  std::uint64_t voxels, number;
};

// The axes of its pictures: to the right, and up.
inline std::array<int, 2> slice_axes(int axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

// Through the middle of a layer; through a point of the axis in scene units; at a share of the space, 0 to 1.
// Throw Error(usage, place, …) where the space has no such layer or point.
SlicePlane plane_of_layer(const GridLayout& finest, int axis, std::int64_t layer, const char* place);
SlicePlane plane_at(const GridLayout& finest, int axis, double position, const char* place);
SlicePlane plane_at_share(const GridLayout& finest, int axis, double share, const char* place);

// The whole layer.
SliceWindow window_of(const GridLayout& finest, int axis);

// A cell's rectangle. Neighbours in a grid share coordinates bit for bit.
SliceWindow in_scene(const GridLayout& finest, int axis, const SliceCell& cell);

// act(cell) for each cell that has voxels in the plane's layer and in the window. The rectangles are whole,
// also where the window cuts them, and don't overlap; those of the whole layer fill it (in grids that
// gridbuild makes). Of a hierarchy for each box that meets the plane within the window, its sides included;
// these are nested, the outer ones first.
void for_each_slice_cell(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                         const std::function<void(const SliceCell&)>& act);

} // namespace masu
