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
#include "libscene/clip.h"

namespace masu {

// One axis of the walk: plane i is crossed at t = i · plane_step + plane_start, and at t the ray is
// t · voxel_step + voxel_start voxels from the space's lower corner.
template <class Real>
struct WalkAxis {
  Real plane_step, plane_start;
  Real voxel_step, voxel_start;
  std::int32_t voxel;
  std::int32_t rising; // 1 or 0

  MASU_HD Real crossing(std::int32_t plane) const {
    return fused(static_cast<Real>(plane), plane_step, plane_start);
  }
  MASU_HD std::int32_t voxel_at(Real t) const { return truncated(fused(t, voxel_step, voxel_start)); }
};

MASU_HD inline std::int32_t held(std::int32_t value, std::int32_t low, std::int32_t high) {
  return smaller(larger(value, low), high);
}

// From outside the space the walk starts in the nearest voxel.
template <class Real>
MASU_HD inline WalkAxis<Real> walk_axis(const ClippedRay<Real>& near, const Vec3<Real>& lower,
                                        const Vec3<Real>& voxel_sizes, const Vec3<Real>& densities,
                                        const Vec3i& divisions, int axis) {
  const Real origin = near.ray.origin[axis], direction = near.ray.direction[axis],
             inverse = near.inverse[axis];
  const Real min = lower[axis], voxels_per_unit = densities[axis];
  const Real plane_step = voxel_sizes[axis] * inverse;
  // A ray that takes so long from plane to plane stays, within any t, where it is but for rounding.
  const bool runs = std::abs(inverse) < RealTraits<Real>::largest &&
                    std::abs(plane_step) < RealTraits<Real>::largest / (1 << 20);
  const Real voxel_start = (origin - min) * voxels_per_unit;
  return {runs ? plane_step : 0,
          runs ? (min - origin) * inverse : static_cast<Real>(INFINITY),
          runs ? direction * voxels_per_unit : 0,
          voxel_start,
          held(truncated(voxel_start), 0, divisions[axis] - 1),
          direction > 0 ? 1 : 0};
}

// A walk under way. Call enter(), and after it leave() until that is false. No branch depends on the ray: a
// warp's lanes stay together.
template <class Real, class Grid>
struct Walk {
  WalkAxis<Real> x{}, y{}, z{};
  CellView cell{};
  Vec3<Real> crossings{}; // where the ray crosses the cell's far planes
  Real exit = 0;          // the first of them: where the ray leaves the cell

  Walk() = default;

  // `near` begins in the space, or just before it.
  MASU_HD Walk(const Grid& grid, const ClippedRay<Real>& near)
      : x(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, grid.division, 0)),
        y(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, grid.division, 1)),
        z(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, grid.division, 2)) {}

  // Looks up the cell that the ray is in.
  MASU_HD void enter(const Grid& grid) {
    cell = cell_at(grid, {x.voxel, y.voxel, z.voxel}, {x.rising, y.rising, z.rising});
    crossings = {x.crossing(cell.far.x), y.crossing(cell.far.y), z.crossing(cell.far.z)};
    exit = least(crossings.x, least(crossings.y, crossings.z));
  }

  // To the voxel beyond the cell's exit; false when the space ends there.
  MASU_HD bool leave(const Grid& grid) {
    const bool by_x = crossings.x == exit;
    const bool by_y = !by_x & (crossings.y == exit);
    const bool by_z = !by_x & !by_y;
    x.voxel = next_voxel(x, cell.far.x, by_x);
    y.voxel = next_voxel(y, cell.far.y, by_y);
    z.voxel = next_voxel(z, cell.far.z, by_z);
    const bool in_x = is_within(x.voxel, grid.division.x), in_y = is_within(y.voxel, grid.division.y),
               in_z = is_within(z.voxel, grid.division.z);
    return in_x & in_y & in_z;
  }

  // Where the ray leaves the space.
  MASU_HD Real end(const Grid& grid) const {
    return least(x.crossing(x.rising * grid.division.x),
                 least(y.crossing(y.rising * grid.division.y), z.crossing(z.rising * grid.division.z)));
  }

  // How many voxels along the axis where they are most the ray passes from t to t + 1.
  MASU_HD Real speed() const {
    return greatest(std::abs(x.voxel_step), greatest(std::abs(y.voxel_step), std::abs(z.voxel_step)));
  }

  // Goes on from t, a place on the ray's way through the space.
  MASU_HD void begin_at(const Grid& grid, Real t) {
    x.voxel = held(x.voxel_at(t), 0, grid.division.x - 1);
    y.voxel = held(y.voxel_at(t), 0, grid.division.y - 1);
    z.voxel = held(z.voxel_at(t), 0, grid.division.z - 1);
    exit = t;
  }

  // How many voxels `voxel` is away: so many steps a walk from voxel to voxel would have taken from there.
  MASU_HD std::int32_t voxels_from(const Vec3i& voxel) const {
    return std::abs(x.voxel - voxel.x) + std::abs(y.voxel - voxel.y) + std::abs(z.voxel - voxel.z);
  }

private:
  // Across the far plane; or as far as the ray has moved on within the cell, held there and never behind the
  // voxel it came from, so that every walk ends.
  MASU_HD std::int32_t next_voxel(const WalkAxis<Real>& axis, std::int32_t far, bool crosses) const {
    const std::int32_t beyond = far - 1 + axis.rising, last = far - axis.rising;
    if (cell.one_voxel) return crosses ? beyond : axis.voxel;
    const std::int32_t reached =
        held(axis.voxel_at(exit), smaller(axis.voxel, last), larger(axis.voxel, last));
    return crosses ? beyond : reached;
  }
  MASU_HD static bool is_within(std::int32_t voxel, std::int32_t division) {
    return static_cast<std::uint32_t>(voxel) < static_cast<std::uint32_t>(division);
  }
};

} // namespace masu
