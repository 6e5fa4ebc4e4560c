// A plane through a grid, perpendicular to an axis: the rectangles in which it cuts the cells.
#pragma once

#include "libgrid/statistics/cells.h"

#include <array>
#include <limits>
#include <vector>

namespace masu {

// A plane perpendicular to `axis` (0 to 2). `layer`: of the smallest voxels, the one that it goes through,
// or that lies above it where it is the face between two. `position`: in scene units.
struct SlicePlane {
  int axis;
  std::int32_t layer;
  double position;
};

// In scene units, along the two axes of slice_axes().
struct SliceWindow {
  std::array<double, 2> min, max;
};

// In the smallest voxels along slice_axes(), from `first` to before `end`. `depth`: how often a voxel of the
// division is halved down to the cell's shortest side; 0 for cells of whole voxels.
struct SliceCell {
  std::array<std::int32_t, 2> first, end;
  std::int32_t depth;
  std::uint32_t references;
  std::uint64_t voxels; // the smallest, in the whole cell
  std::uint64_t number; // as in GridCell
};

struct Slice {
  SlicePlane plane;
  GridLayout finest; // its smallest voxels
  std::int32_t nested_log2;
  std::vector<SliceCell> cells; // in the order of their numbers
};

// The axes of its pictures: to the right, and up.
inline std::array<int, 2> slice_axes(int axis) {
  return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

// Through the middle of a layer; through a point of the axis in scene units. Throw Error(usage, place, …)
// where the space has no such layer or point.
SlicePlane plane_of_layer(const GridLayout& finest, int axis, std::int64_t layer, const char* place);
SlicePlane plane_at(const GridLayout& finest, int axis, double position, const char* place);

// The whole layer.
SliceWindow window_of(const GridLayout& finest, int axis);

// act(cell) for each cell that has voxels in the plane's layer and in the window. The rectangles are whole,
// also where the window cuts them, and don't overlap; those of the whole layer fill it (in grids that
// gridbuild makes).
using SliceAction = std::function<void(const SliceCell&)>;
void for_each_slice_cell(const GridFile& file, const SlicePlane& plane, const SliceWindow& window,
                         const SliceAction& act);

// All of them. Throws Error(usage, place, …) for more than `most`.
Slice slice_of(const GridFile& file, const SlicePlane& plane, const SliceWindow& window, const char* place,
               std::size_t most = std::numeric_limits<std::size_t>::max());

} // namespace masu
