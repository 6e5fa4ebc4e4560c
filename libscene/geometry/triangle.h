// Ray and triangle, watertight: after Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT
// 2(1), 2013.
//
// Vertices are moved to the ray's origin and projected along the ray; each vertex by itself, so that
// triangles that share it agree where it is. There the ray is the point (0, 0), and which side of an edge it
// lies on is decided exactly: the three edge functions are differences of products whose sign is right short
// of underflow. So no ray slips between triangles that share an edge or a corner, and no second, wider
// arithmetic is needed. (The paper shears along the ray's dominant axis; two vectors across the ray need no
// permutation of the axes, which a GPU can't index.)
#pragma once

#include "libscene/geometry/ray.h"

namespace masu {

// Twice the signed areas, projected along the ray, of what the ray's point makes with the edge opposite each
// corner.
template <class Real>
struct EdgeFunctions {
  Real a, b, c;
};

template <class Real>
MASU_SMALL EdgeFunctions<Real> edge_functions(const WatertightRay<Real>& ray, const Vec3<Real>& a,
                                              const Vec3<Real>& b, const Vec3<Real>& c) {
  const Real ax = dot(ray.across1, a), ay = dot(ray.across2, a);
  const Real bx = dot(ray.across1, b), by = dot(ray.across2, b);
  const Real cx = dot(ray.across1, c), cy = dot(ray.across2, c);
  return {difference_of_products(cx, by, cy, bx), difference_of_products(ax, cy, ay, cx),
          difference_of_products(bx, ay, by, ax)};
}

// Whether the ray's line meets the triangle, edges and corners included, from either side; then `t` is where.
// A triangle seen exactly edge-on isn't met: its neighbours are.
template <class Real, class Stored>
MASU_SMALL bool intersect(const WatertightRay<Real>& ray, const Triangle<Stored>& triangle, Real& t) {
  const Vec3<Real> a = cast<Real>(triangle.a) - ray.origin;
  const Vec3<Real> b = cast<Real>(triangle.b) - ray.origin;
  const Vec3<Real> c = cast<Real>(triangle.c) - ray.origin;
  const EdgeFunctions<Real> e = edge_functions(ray, a, b, c);
  const Real lowest = fast_min(e.a, fast_min(e.b, e.c)), highest = fast_max(e.a, fast_max(e.b, e.c));
  const bool outside = (lowest < 0) & (highest > 0);
  const Real sum = e.a + e.b + e.c; // inside all are of one sign, and it cancels nothing
  if (outside | (sum == 0)) return false;
  // A mean of the corners' distances along the ray, each weighted by its share of the sum; which is brought
  // to size first, where products with it would leave the range.
  const Real size = sum < 0x1p-60F && sum > -0x1p-60F ? Real(0x1p60F) : Real(1);
  const Real weighted = fma(e.a * size, dot(ray.direction, a),
                            fma(e.b * size, dot(ray.direction, b), e.c * size * dot(ray.direction, c)));
  t = fast_divide(weighted, sum * size) * ray.inverse_square;
  return true;
}

template <class Real, class Stored>
MASU_HD inline bool intersect(const PreparedRay<Real>& ray, const Triangle<Stored>& triangle, Real& t) {
  return intersect(prepare_watertight(ray), triangle, t);
}

} // namespace masu
