// The walk of a ray from cell to cell, after Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray
// Tracing", Eurographics 1987, with each plane's distance computed from its number, never by adding up steps;
// through cells of many voxels as Pérard-Gayot, Kalojanov & Slusallek, "GPU Ray Tracing using Irregular
// Grids", CGF 36(2), 2017.
//
// Why the grid never shows: along an axis the cell at distance t is bounded by planes whose computed
// distances enclose t; each is off by less than the builder's margin (libscene/margin.h). So when the walk
// has reached t, every primitive with a computed hit up to t is listed in a cell that was visited. A visitor
// that stops once its nearest hit is no farther than the cell's exit has therefore seen all that could be
// nearer, or as near.
#pragma once

#include "libgrid/grid_view.h"

namespace masu {

// A coordinate's voxel along one axis, counted from the space's lower corner in voxels; anything outside goes
// to the nearest, NaN to 0.
template <class Real>
MASU_HD inline std::int32_t voxel_of(Real at, std::int32_t division) {
  if (!(at > 0)) return 0;
  return at < static_cast<Real>(division) ? static_cast<std::int32_t>(at) : division - 1;
}

// One axis of the walk: plane i is crossed at t = i · plane_step + plane_start, and at t the ray is
// t · voxel_step + voxel_start voxels from the space's lower corner.
template <class Real>
struct WalkAxis {
  Real plane_step, plane_start;
  Real voxel_step, voxel_start;
  std::int32_t voxel;

  MASU_HD Real crossing(std::int32_t plane) const {
    return fused(static_cast<Real>(plane), plane_step, plane_start);
  }
};

template <class Real>
MASU_HD inline WalkAxis<Real> walk_axis(Real origin, Real direction, Real min, Real voxel_size,
                                        Real voxels_per_unit, std::int32_t division) {
  const Real start = (origin - min) * voxels_per_unit;
  const std::int32_t voxel = voxel_of(start, division);
  const Real inverse = 1 / direction, plane_step = voxel_size * inverse;
  // A ray that takes so long from plane to plane stays, within any t, where it is but for rounding.
  if (!(std::abs(plane_step) < RealTraits<Real>::largest / (1 << 20)))
    return {0, static_cast<Real>(INFINITY), 0, start, voxel};
  return {plane_step, (min - origin) * inverse, direction * voxels_per_unit, start, voxel};
}

// A walk under way. `origin` lies in the space (clip.h). Call enter(), and after it leave() until that is
// false.
template <class Real, class Grid>
struct Walk {
  WalkAxis<Real> x, y, z;
  Vec3<bool> forward;
  CellView cell;
  Vec3<Real> crossings; // where the ray crosses the cell's far planes
  Real exit;            // the first of them: where the ray leaves the cell

  MASU_HD Walk(const Grid& grid, const Vec3<Real>& origin, const Vec3<Real>& direction)
      : x(walk_axis(origin.x, direction.x, grid.min.x, grid.voxel_size.x, grid.voxels_per_unit.x,
                    grid.division.x)),
        y(walk_axis(origin.y, direction.y, grid.min.y, grid.voxel_size.y, grid.voxels_per_unit.y,
                    grid.division.y)),
        z(walk_axis(origin.z, direction.z, grid.min.z, grid.voxel_size.z, grid.voxels_per_unit.z,
                    grid.division.z)),
        forward{direction.x > 0, direction.y > 0, direction.z > 0}, cell{}, crossings{}, exit(0) {}

  // Looks up the cell that the ray is in.
  MASU_HD void enter(const Grid& grid) {
    cell = cell_at(grid, {x.voxel, y.voxel, z.voxel}, forward);
    crossings = {x.crossing(cell.far.x), y.crossing(cell.far.y), z.crossing(cell.far.z)};
    exit = smaller(crossings.x, smaller(crossings.y, crossings.z));
  }

  // To the voxel beyond the cell's exit; false when the space ends there.
  MASU_HD bool leave(const Grid& grid) {
    const bool by_x = crossings.x == exit, by_y = !by_x && crossings.y == exit, by_z = !(by_x || by_y);
    // Along the other axes the ray has moved on within the cell.
    if (!cell.one_voxel) {
      if (!by_x) follow(x, cell.far.x, forward.x, grid.division.x);
      if (!by_y) follow(y, cell.far.y, forward.y, grid.division.y);
      if (!by_z) follow(z, cell.far.z, forward.z, grid.division.z);
    }
    if (by_x) return cross(x, cell.far.x, forward.x, grid.division.x);
    if (by_y) return cross(y, cell.far.y, forward.y, grid.division.y);
    return cross(z, cell.far.z, forward.z, grid.division.z);
  }

  // How many voxels the walk has come from `origin`'s: what a walk from voxel to voxel would have taken.
  MASU_HD std::int32_t voxels_from(const Vec3i& voxel) const {
    return std::abs(x.voxel - voxel.x) + std::abs(y.voxel - voxel.y) + std::abs(z.voxel - voxel.z);
  }

private:
  // The voxel reached at the exit, held inside the cell and never behind the one it came from, so that every
  // walk ends.
  MASU_HD void follow(WalkAxis<Real>& axis, std::int32_t far, bool rising, std::int32_t division) const {
    const std::int32_t reached = voxel_of(fused(exit, axis.voxel_step, axis.voxel_start), division);
    const std::int32_t low = rising ? axis.voxel : far, high = rising ? far - 1 : axis.voxel;
    axis.voxel = reached < low ? low : reached > high ? high : reached;
  }
  MASU_HD static bool cross(WalkAxis<Real>& axis, std::int32_t far, bool rising, std::int32_t division) {
    axis.voxel = rising ? far : far - 1;
    return static_cast<std::uint32_t>(axis.voxel) < static_cast<std::uint32_t>(division);
  }
};

// Visits the cells that the ray meets, in order.
// visitor.cell(list): a cell; empty_list for an empty one.
// visitor.done(exit): whether the walk may end, now that all cells up to t = exit have been visited.
// visitor.moved(voxels): on to the next cell, so many voxels away.
template <class Real, class Grid, class Visitor>
MASU_HD inline void walk(const Grid& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                         Visitor& visitor) {
  Walk<Real, Grid> walk(grid, origin, direction);
  for (;;) {
    walk.enter(grid);
    visitor.cell(walk.cell.list);
    if (visitor.done(walk.exit)) return;
    const Vec3i from{walk.x.voxel, walk.y.voxel, walk.z.voxel};
    if (!walk.leave(grid)) return;
    visitor.moved(walk.voxels_from(from));
  }
}

} // namespace masu
