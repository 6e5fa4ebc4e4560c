// Ray and triangle, watertight: after Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT
// 2(1), 2013.
//
// Vertices are translated to the ray's origin and projected along the ray, each by itself, so that triangles
// that share a vertex project it alike. The ray becomes the point (0, 0); its side of an edge is decided
// exactly, since the three edge functions are differences of products whose sign is exact unless they
// underflow. So no ray passes between triangles that share an edge or a corner, and no fallback to double is
// needed. (The paper shears along the ray's dominant axis. Projecting on two vectors perpendicular to the ray
// needs no permutation of axes, which on a GPU would index registers.)
#pragma once

#include "libscene/geometry/ray.h"

namespace masu {

// Unnormalised barycentric coordinates: twice the signed area, projected along the ray, of the triangle of
// the ray's point and the edge opposite each corner.
template <class Real>
struct EdgeFunctions {
  Real a, b, c;
};

// A corner, relative to the ray's origin, seen along the ray: in the coordinates of across1 and across2,
// which with the direction are a right-handed system.
template <class Real>
struct Projected {
  Real x, y;
};
template <class Real>
MASU_ALWAYS_INLINE Projected<Real> projected(const WatertightRay<Real>& ray, const Vec3<Real>& corner) {
  return {dot(ray.across1, corner), dot(ray.across2, corner)};
}

template <class Real>
MASU_ALWAYS_INLINE EdgeFunctions<Real> edge_functions(const WatertightRay<Real>& ray, const Vec3<Real>& a,
                                                      const Vec3<Real>& b, const Vec3<Real>& c) {
  const Projected<Real> p = projected(ray, a), q = projected(ray, b), r = projected(ray, c);
  return {difference_of_products(r.x, q.y, r.y, q.x), difference_of_products(p.x, r.y, p.y, r.x),
          difference_of_products(q.x, p.y, q.y, p.x)};
}

// Whether the ray's line meets the triangle from either side, edges and corners included; then sets `t`,
// which may be negative. A triangle seen exactly edge-on isn't met, its neighbours are.
template <class Real, class Stored>
MASU_ALWAYS_INLINE bool intersect(const WatertightRay<Real>& ray, const Triangle<Stored>& triangle, Real& t) {
  const Vec3<Real> a = cast<Real>(triangle.a) - ray.origin;
  const Vec3<Real> b = cast<Real>(triangle.b) - ray.origin;
  const Vec3<Real> c = cast<Real>(triangle.c) - ray.origin;
  const EdgeFunctions<Real> e = edge_functions(ray, a, b, c);
  const Real lowest = fast_min(e.a, fast_min(e.b, e.c)), highest = fast_max(e.a, fast_max(e.b, e.c));
  const bool outside = (lowest < 0) & (highest > 0);
  const Real sum = e.a + e.b + e.c; // inside all have one sign, and nothing cancels
  if (outside | (sum == 0)) return false;
  // The corners' distances along the ray, interpolated by the barycentric coordinates; small ones are scaled
  // so that no product underflows.
  const Real scale = sum < 0x1p-60F && sum > -0x1p-60F ? Real(0x1p60F) : Real(1);
  const Real weighted = fma(e.a * scale, dot(ray.direction, a),
                            fma(e.b * scale, dot(ray.direction, b), e.c * scale * dot(ray.direction, c)));
  t = fast_divide(weighted, sum * scale) * ray.inverse_square;
  return true;
}

template <class Real, class Stored>
MASU_HD inline bool intersect(const PreparedRay<Real>& ray, const Triangle<Stored>& triangle, Real& t) {
  return intersect(prepare_watertight(ray), triangle, t);
}

} // namespace masu
