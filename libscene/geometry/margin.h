// The error bound of computed hits and of grid traversal, and so how far beyond its surface a primitive must
// be listed in cells for no grid to miss it.
//
// Let u be the unit roundoff and M the largest coordinate of the scene's bounds. A ray is first clipped to
// the bounds (clip.h), so that every origin o has |o| ≤ M and every vertex lies within 2√3 M of it, both up
// to the padding and the rounding of the entry.
//  - Clipping rounds o, several times from far away: 8 u M, from up to 1 / (2 u) times M away. From beyond
//    that the first clip leaves o some M before the bounds, and so rounds it by more.
//  - A ray of a list (ray_query.h) is rounded to float32 within ±4 M: along each axis its origin by 4 u M,
//    its direction by u times the 5 M at most up to the hit. In all below 16 u M.
//  - Triangles (triangle.h): subtracting o moves a vertex by 2√3 u M; projecting it, across the ray and along
//    it, by (3 + 4) u 2√3 M each; the edge functions have small relative errors and exact signs, so the hit
//    lies on the moved triangle up to 9 u 2√3 M along the ray. In all below 89 u M (the worst case found by
//    search: 16).
//  - Spheres (sphere.h): the same subtraction and projection, and a square root: below 60 u M (found: 15).
//  - Cones (cone.h) are solved about the point where the quadratic's terms are smallest: below 60 u M
//    (millions of hard cases found none worse).
//  - Traversal (libgrid/grid/grid_walk.h): the distance of plane i along the ray is one fma of two factors,
//  each
//    rounded three times: below 14 u M along that axis; the voxel reached at an exit is another fma, below
//    14 u M too.
// What moves a ray before it is traced moves it for every grid alike: grids need the tests' and the
// traversal's sum, below 117 u M. A hit lies within the sum of all but the traversal's, below 113 u M, of the
// surface. 128 u M covers either. The space that is divided, and the box that rays are clipped to, extend
// twice that beyond the bounds: so a hit on a face of the bounds, and the traversal to it, stay inside, and
// flat scenes get a thickness.
#pragma once

#include "libscene/geometry/box.h"

namespace masu {

inline constexpr int margin_roundings = 128; // in units of u M

// For arithmetic of type Real on primitives within `bounds` (not empty).
template <class Real>
MASU_HD inline double rounding_margin(const Boxd& bounds) {
  return margin_roundings * static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(bounds);
}

// The box that rays are clipped to and that a tight space divides. Not empty, even without primitives.
template <class Real>
MASU_HD inline Boxd padded_bounds(const Boxd& bounds) {
  if (is_empty(bounds)) return {{-1, -1, -1}, {1, 1, 1}};
  return grown(bounds, 2 * rounding_margin<Real>(bounds));
}

} // namespace masu
