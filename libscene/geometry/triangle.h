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

// So many times t is as far as corners may lie along the ray for the interpolation of their distances to be
// good enough: with an error of 8 u times that, it is off by less than 2^-16 of t.
inline constexpr float farthest_corner = 32;

// Beyond that t may come from one of the corners' coordinates instead of their distances along the ray:
// interpolated, it is that of the hit. Its error is the smaller the less the triangle extends along that
// axis, seen from the ray's origin, as a floor does upwards: the axis with the least error is taken, if the
// ray advances along it by a third of its length or more (margin.h says why). `weights`: edge functions, of
// sum `sum`; `farthest`: the largest distance along the ray. Real: a number, or eight.
template <class Real>
MASU_ALWAYS_INLINE Real short_t(const WatertightRay<Real>& ray, const Vec3<Real>& a, const Vec3<Real>& b,
                                const Vec3<Real>& c, const EdgeFunctions<Real>& weights, const Real& sum,
                                const Real& farthest, const Real& otherwise) {
  const auto largest = [](const Real& p, const Real& q, const Real& r) {
    return fast_max(magnitude(p), fast_max(magnitude(q), magnitude(r)));
  };
  Real at_a = a.x, at_b = b.x, at_c = c.x, speed = ray.direction.x, extent = largest(at_a, at_b, at_c);
  const auto try_axis = [&](const Real& p, const Real& q, const Real& r, const Real& along) {
    const Real own = largest(p, q, r);
    const auto is_better = own * magnitude(speed) < extent * magnitude(along);
    at_a = select(is_better, p, at_a);
    at_b = select(is_better, q, at_b);
    at_c = select(is_better, r, at_c);
    speed = select(is_better, along, speed);
    extent = select(is_better, own, extent);
  };
  try_axis(a.y, b.y, c.y, ray.direction.y);
  try_axis(a.z, b.z, c.z, ray.direction.z);
  const Real weighted = fma(weights.a, at_a, fma(weights.b, at_b, weights.c * at_c));
  const auto is_better = (Real(8) * extent < farthest * ray.inverse_square * magnitude(speed)) &
                         (Real(1) <= Real(8) * speed * speed * ray.inverse_square);
  return select(is_better, fast_divide(weighted, sum * speed), otherwise);
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
  const EdgeFunctions<Real> weights{e.a * scale, e.b * scale, e.c * scale};
  const Real at_a = dot(ray.direction, a), at_b = dot(ray.direction, b), at_c = dot(ray.direction, c);
  const Real along = fast_divide(fma(weights.a, at_a, fma(weights.b, at_b, weights.c * at_c)), sum * scale);
  t = along * ray.inverse_square;
  const Real farthest = fast_max(std::abs(at_a), fast_max(std::abs(at_b), std::abs(at_c)));
  if ((t > 0) & (farthest > Real(farthest_corner) * along))
    t = short_t(ray, a, b, c, weights, sum * scale, farthest, t);
  return true;
}

template <class Real, class Stored>
MASU_HD inline bool intersect(const PreparedRay<Real>& ray, const Triangle<Stored>& triangle, Real& t) {
  return intersect(prepare_watertight(ray), triangle, t);
}

} // namespace masu
