// The walk of a ray from cell to cell, after Amanatides & Woo, "A Fast Voxel Traversal Algorithm for Ray
// Tracing", Eurographics 1987, with each plane's distance computed from its number, never by adding up steps;
// through cells of many voxels as Pérard-Gayot, Kalojanov & Slusallek, "GPU Ray Tracing using Irregular
// Grids", CGF 36(2), 2017.
//
// Results are independent of the grid: along an axis the cell at distance t is bounded by planes whose
// computed distances enclose t; each is off by less than the builder's margin (libscene/geometry/margin.h).
// So when the walk has reached t, every primitive with a computed hit up to t is listed in a cell that was
// visited. A visitor that stops once its nearest hit is no farther than the cell's exit has therefore seen
// all that could be nearer, or as near.
#pragma once

#include "libgrid/grid/grid.h"
#include "libscene/geometry/clip.h"
#include "libscene/geometry/intersect.h"

namespace masu {

// Whether counts are also shown each ray, cell or node, and test (renderer/rays/walk_report.h): they have a
// member records_walk. For others no code is compiled.
template <class Counts>
inline constexpr bool records_walk = requires {
  Counts::records_walk;
};

// Counts nothing.
struct NoWalkCounts : NoTestCounts {
  static constexpr bool is_counted = false;
  MASU_HD void cell(bool) {}
  MASU_HD void skipped(std::int32_t) {}
};

// One axis of the walk: plane i is crossed at t = i · plane_step + plane_start, and at t the ray is
// t · voxel_step + voxel_start voxels from the space's lower corner.
template <class Real>
struct WalkAxis {
  Real plane_step, plane_start;
  Real voxel_step, voxel_start;
  std::int32_t reversed; // 0, or -1 where the ray runs towards lower numbers
  std::int32_t at;       // the voxel as along() has it

  // Numbers along the ray: n, or -1 - n where it is reversed. So a walk only ever counts up.
  MASU_HD std::int32_t along(std::int32_t voxel) const { return voxel ^ reversed; }
  MASU_HD std::int32_t voxel() const { return at ^ reversed; }
  MASU_HD Real crossing(std::int32_t plane) const {
    return fma(static_cast<Real>(plane), plane_step, plane_start);
  }
  MASU_HD std::int32_t voxel_at(Real t) const { return truncated(fma(t, voxel_step, voxel_start)); }
};

MASU_HD inline std::int32_t clamp(std::int32_t value, std::int32_t low, std::int32_t high) {
  return min(max(value, low), high);
}

template <class Real>
MASU_HD inline WalkAxis<Real> walk_axis(const ClippedRay<Real>& near, const Vec3<Real>& lower,
                                        const Vec3<Real>& voxel_sizes, const Vec3<Real>& densities,
                                        int axis) {
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
          direction > 0 ? 0 : -1,
          0};
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
      : x(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, 0)),
        y(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, 1)),
        z(walk_axis(near, grid.min, grid.voxel_size, grid.voxels_per_unit, 2)) {
    begin_at(grid, near.ray.t_min);
  }

  // Looks up the cell that the ray is in.
  MASU_HD void enter(const Grid& grid) {
    cell = cell_at(grid, voxel(), {x.reversed, y.reversed, z.reversed});
    crossings = {x.crossing(cell.far.x), y.crossing(cell.far.y), z.crossing(cell.far.z)};
    exit = fast_min(crossings.x, fast_min(crossings.y, crossings.z));
  }

  // To the voxel beyond the cell's exit; false when the space ends there.
  MASU_HD bool leave(const Grid& grid) {
    const bool by_x = crossings.x == exit;
    const bool by_y = !by_x & (crossings.y == exit);
    const bool by_z = !by_x & !by_y;
    x.at = next_along(x, cell.far.x, by_x);
    y.at = next_along(y, cell.far.y, by_y);
    z.at = next_along(z, cell.far.z, by_z);
    const Vec3i now = voxel();
    const bool in_x = is_within(now.x, grid.division.x), in_y = is_within(now.y, grid.division.y),
               in_z = is_within(now.z, grid.division.z);
    return in_x & in_y & in_z;
  }

  // Where the ray leaves the space.
  MASU_HD Real end(const Grid& grid) const {
    return fast_min(
        x.crossing(grid.division.x & ~x.reversed),
        fast_min(y.crossing(grid.division.y & ~y.reversed), z.crossing(grid.division.z & ~z.reversed)));
  }

  // How many voxels along the axis where they are most the ray passes from t to t + 1.
  MASU_HD Real speed() const {
    return fast_max(std::abs(x.voxel_step), fast_max(std::abs(y.voxel_step), std::abs(z.voxel_step)));
  }

  // Goes on from t, a place on the ray's way through the space; from outside in the nearest voxel.
  MASU_HD void begin_at(const Grid& grid, Real t) {
    x.at = x.along(clamp(x.voxel_at(t), 0, grid.division.x - 1));
    y.at = y.along(clamp(y.voxel_at(t), 0, grid.division.y - 1));
    z.at = z.along(clamp(z.voxel_at(t), 0, grid.division.z - 1));
    exit = t;
  }

  MASU_HD Vec3i voxel() const { return {x.voxel(), y.voxel(), z.voxel()}; }

  // How many voxels `from` is away: so many steps a walk from voxel to voxel would have taken from there.
  MASU_HD std::int32_t voxels_from(const Vec3i& from) const {
    const Vec3i now = voxel();
    return std::abs(now.x - from.x) + std::abs(now.y - from.y) + std::abs(now.z - from.z);
  }

private:
  // Across the far plane; or as far as the ray has moved on within the cell, clamped to it and never behind
  // the voxel it came from, so that every walk ends.
  MASU_HD std::int32_t next_along(const WalkAxis<Real>& axis, std::int32_t far, bool crosses) const {
    const std::int32_t beyond = axis.along(far) - axis.reversed; // of the plane: its two voxels are 1 apart
    if (cell.one_voxel) return crosses ? beyond : axis.at;
    const std::int32_t reached = max(min(axis.along(axis.voxel_at(exit)), beyond - 1), axis.at);
    return crosses ? beyond : reached;
  }
  MASU_HD static bool is_within(std::int32_t voxel, std::int32_t division) {
    return static_cast<std::uint32_t>(voxel) < static_cast<std::uint32_t>(division);
  }
};

} // namespace masu
