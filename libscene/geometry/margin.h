// How far computed hits and walks may be from where they should be, and so how far beyond its surface a
// primitive must be listed for no grid to miss it.
//
// Let u be the unit roundoff and M the largest coordinate of the scene's bounds. A ray is first clipped to
// the bounds (clip.h), so every origin o has |o| ≤ M but for the padding and the entry's rounding, and every
// vertex lies within 2√3 M of it, or hardly more.
//  - Clipping rounds o, twice from afar: 8 u M.
//  - Triangles (triangle.h): subtracting o moves a vertex by 2√3 u M; projecting it, across the ray and along
//    it, by (3 + 4) u 2√3 M each; the edge functions keep their digits and their signs, and so the hit lies
//    on the moved triangle up to 9 u 2√3 M along the ray. In all below 89 u M (searched for: 16).
//  - Spheres (sphere.h): the same subtraction and projection, and a square root: below 60 u M (searched for:
//    15).
//  - Cones (cone.h) are solved about the place where their terms are least: below 60 u M (millions of hard
//    cases found none worse).
//  - The walk (libgrid/trace/walk.h): plane i's distance along the ray is one fused multiply-add of two
//  factors
//    rounded thrice, below 14 u M along that axis; the voxel reached at an exit another, below 14 u M too.
// 128 u M covers their sum. The space that is divided, and the box that rays are clipped to, reach twice that
// beyond the bounds: a hit on the bounds' own face, and a walk to it, stay inside. That also gives flat
// scenes a thickness.
#pragma once

#include "libscene/geometry/box.h"

namespace masu {

inline constexpr int margin_roundings = 128; // in u M

// For arithmetic of type Real on primitives within `bounds` (not empty).
template <class Real>
inline double rounding_margin(const Boxd& bounds) {
  return margin_roundings * static_cast<double>(RealTraits<Real>::unit_roundoff) * largest_magnitude(bounds);
}

// What rays are clipped to, and what the tight space divides. A scene without primitives gets a box all the
// same.
template <class Real>
inline Boxd padded_bounds(const Boxd& bounds) {
  if (is_empty(bounds)) return {{-1, -1, -1}, {1, 1, 1}};
  return grown(bounds, 2 * rounding_margin<Real>(bounds));
}

} // namespace masu
