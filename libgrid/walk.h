// The walk of a ray from cell to cell, after Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray
// Tracing", Eurographics 1987, with each plane's distance computed from its number, never by adding up steps.
//
// Why the grid never shows: along an axis the cell at distance t is bounded by planes whose computed
// distances enclose t; each is off by less than the builder's margin (libscene/margin.h). So when the walk
// has reached t, every primitive with a computed hit up to t is listed in a cell that was visited. A visitor
// that stops once its nearest hit is no farther than the cell's exit has therefore seen all that could be
// nearer, or as near.
#pragma once

#include "libgrid/grid_view.h"

namespace masu {

// A coordinate's voxel along one axis; anything outside goes to the nearest, NaN to 0.
template <class Real>
MASU_HD inline std::int32_t voxel_of(Real at, Real min, Real voxels_per_unit, std::int32_t division) {
  const Real voxel = (at - min) * voxels_per_unit;
  if (!(voxel > 0)) return 0;
  return voxel < static_cast<Real>(division) ? static_cast<std::int32_t>(voxel) : division - 1;
}

// One axis of the walk.
template <class Real>
struct WalkAxis {
  Real origin, inverse; // of the ray; -∞ and +∞ where it runs across the axis, which puts every plane at +∞
  Real min, size;
  std::int32_t voxel, division;
  bool forward;
};

template <class Real>
MASU_HD inline WalkAxis<Real> walk_axis(const GridView<Real>& grid, const Vec3<Real>& origin,
                                        const Vec3<Real>& direction, int axis) {
  const Real infinity = static_cast<Real>(INFINITY);
  // A step this short can't leave a voxel within any t, and its inverse would overflow.
  const bool runs = std::abs(direction[axis]) >= RealTraits<Real>::smallest_normal * 8;
  return {runs ? origin[axis] : -infinity,
          runs ? 1 / direction[axis] : infinity,
          grid.min[axis],
          grid.voxel_size[axis],
          voxel_of(origin[axis], grid.min[axis], grid.voxels_per_unit[axis], grid.division[axis]),
          grid.division[axis],
          direction[axis] > 0};
}

// Where the ray crosses the far side of the block of 2^side_log2 voxels that the axis' voxel is in.
template <class Real>
MASU_HD inline Real exit_distance(const WalkAxis<Real>& axis, int side_log2) {
  const std::int32_t block = axis.voxel >> side_log2;
  const std::int32_t plane = (axis.forward ? block + 1 : block) << side_log2;
  return (fused(static_cast<Real>(plane), axis.size, axis.min) - axis.origin) * axis.inverse;
}

// Steps over that side; false when it was the space's own.
template <class Real>
MASU_HD inline bool step(WalkAxis<Real>& axis, int side_log2) {
  const std::int32_t block = axis.voxel >> side_log2;
  axis.voxel = axis.forward ? (block + 1) << side_log2 : (block << side_log2) - 1;
  return static_cast<std::uint32_t>(axis.voxel) < static_cast<std::uint32_t>(axis.division);
}

// After t along a ray that left its block by another axis: the voxel reached, held inside the block and never
// behind the voxel it came from, so that every walk ends.
template <class Real>
MASU_HD inline void follow(WalkAxis<Real>& axis, Real at, Real voxels_per_unit, int side_log2) {
  const std::int32_t first = (axis.voxel >> side_log2) << side_log2;
  const std::int32_t past_last = first + (1 << side_log2);
  const std::int32_t last = (past_last < axis.division ? past_last : axis.division) - 1;
  const std::int32_t reached = voxel_of(at, axis.min, voxels_per_unit, axis.division);
  const std::int32_t low = axis.forward ? axis.voxel : first, high = axis.forward ? last : axis.voxel;
  axis.voxel = reached < low ? low : reached > high ? high : reached;
}

// Visits the cells that the ray meets, in order. `origin` lies in the space (clip.h).
// visitor.cell(first, last): an occupied cell's references are [first, last).
// visitor.empty_cell(skipped): an empty cell; `skipped` voxels of it need no visit of their own.
// visitor.done(exit): whether the walk may end, now that all cells up to t = exit have been visited.
template <class Real, class Visitor>
MASU_HD inline void walk(const GridView<Real>& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                         Visitor& visitor) {
  WalkAxis<Real> x = walk_axis(grid, origin, direction, 0);
  WalkAxis<Real> y = walk_axis(grid, origin, direction, 1);
  WalkAxis<Real> z = walk_axis(grid, origin, direction, 2);
  for (;;) {
    const MapEntry entry = look_up(grid, {x.voxel, y.voxel, z.voxel});
    const int side = entry.side_log2;
    const Real exit_x = exit_distance(x, side), exit_y = exit_distance(y, side),
               exit_z = exit_distance(z, side);
    const Real exit = smaller(exit_x, smaller(exit_y, exit_z));
    if ((entry.word & occupied_bit) != 0) {
      const std::uint32_t cell = entry.word & ~occupied_bit;
      visitor.cell(grid.cells[cell], grid.cells[cell + 1]);
    } else {
      visitor.empty_cell((std::uint64_t{1} << (3 * side)) - 1);
    }
    if (visitor.done(exit)) return;
    const bool by_x = exit_x == exit, by_y = !by_x && exit_y == exit;
    const bool inside = by_x ? step(x, side) : by_y ? step(y, side) : step(z, side);
    if (!inside) return;
    if (side > 0) {
      const Vec3<Real> at = fused(direction, exit, origin);
      if (!by_x) follow(x, at.x, grid.voxels_per_unit.x, side);
      if (!by_y) follow(y, at.y, grid.voxels_per_unit.y, side);
      if (by_x || by_y) follow(z, at.z, grid.voxels_per_unit.z, side);
    }
  }
}

} // namespace masu
