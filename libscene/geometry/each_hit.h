// Every hit of a ray with a primitive, for lists of hits, and for queries of one side of surfaces.
//
// A closed mesh is crossed once where a ray passes an edge or a corner of it, though all triangles there are
// met: EdgeRule::half_open. It is Edelsbrunner & Mücke's "Simulation of Simplicity", ACM Transactions on
// Graphics 9(1), 1990. Seen along the ray, corners are points of a plane and the ray is the point 0. It is
// moved to (e, e²) for an e > 0 smaller than any number that occurs. For an edge from p to q that point's
// side is the sign of
//
//   (p - (e, e²)) × (q - (e, e²)) = p × q - e (q.y - p.y) + e² (q.x - p.x),
//
// the sign of the first of the three terms that isn't 0; it is 0 for p = q alone. A triangle is met where its
// three edges have the same sign, not 0.
//
//  - Exact: a corner's point depends on the ray and the corner alone, so that triangles which share an edge,
//    by number or by coordinates, have the same p and q. Differences q.y - p.y are compared, not computed,
//    and the sign of p × q is exact: of floats, products are exact in double; of doubles, by Kahan's
//    algorithm, as long as no product is below 1e-270.
//  - So the moved point lies on no edge, and each edge changes signs for both its triangles alike: what is
//    counted is which triangles of a mesh in the plane contain a point in general position. In a mesh whose
//    every edge belongs to an even number of triangles they are even in number; and where the edge's
//    triangles run through it in opposite directions, half of them show the front, half the back.
//  - A triangle seen edge-on has the sum 0 of p × q, and of all terms: never three signs alike.
//  - Of an even number, those with t > 0 are odd in number just where the origin is inside: t is wrong in
//    sign only for a surface that the error bound (margin.h) doesn't tell from the origin.
#pragma once

#include "libscene/geometry/intersect.h"
#include "libscene/geometry/orientation.h"

namespace masu {

// closed: edges and corners belong to all their triangles, as nearest_hit() has it. half_open: to one of the
// triangles on either side of the ray.
enum class EdgeRule { closed, half_open };

// p × q with its exact sign.
MASU_HD inline double exact_cross(const Projected<float>& p, const Projected<float>& q) {
  return static_cast<double>(p.x) * static_cast<double>(q.y) -
         static_cast<double>(p.y) * static_cast<double>(q.x);
}
MASU_HD inline double exact_cross(const Projected<double>& p, const Projected<double>& q) {
  return difference_of_products(p.x, q.y, p.y, q.x);
}

// The side of an edge on which the moved point is: 1, -1, or 0 for an edge that is a point.
template <class Real>
MASU_HD inline int side_of(const Projected<Real>& p, const Projected<Real>& q, double cross) {
  const auto sign = [](bool positive) { return positive ? 1 : -1; };
  if (cross != 0) return sign(cross > 0);
  if (p.y != q.y) return sign(q.y < p.y);
  return p.x == q.x ? 0 : sign(q.x > p.x);
}

// Whether the ray's line crosses the triangle by the half-open rule; then sets t, which may be negative: but
// for triangles that are hardly more than a point, or seen nearly edge-on, the bits of intersect(). `front`:
// it meets the front.
template <class Real, class Stored>
MASU_HD inline bool crosses(const WatertightRay<Real>& ray, const Triangle<Stored>& triangle, Real& t,
                            bool& front) {
  const Vec3<Real> a = cast<Real>(triangle.a) - ray.origin, b = cast<Real>(triangle.b) - ray.origin,
                   c = cast<Real>(triangle.c) - ray.origin;
  const Projected<Real> p = projected(ray, a), q = projected(ray, b), r = projected(ray, c);
  const double pq = exact_cross(p, q), qr = exact_cross(q, r), rp = exact_cross(r, p);
  const int side = side_of(p, q, pq);
  if (side == 0 || side != side_of(q, r, qr) || side != side_of(r, p, rp)) return false;
  front = side < 0;
  const double sum = pq + qr + rp;
  constexpr double smallest = sizeof(Real) == sizeof(float) ? 0x1p-60 : 0x1p-900;
  if (std::abs(sum) >= smallest) return intersect(ray, triangle, t);
  // In Real something might underflow.
  const double weighted = qr * static_cast<double>(dot(ray.direction, a)) +
                          rp * static_cast<double>(dot(ray.direction, b)) +
                          pq * static_cast<double>(dot(ray.direction, c));
  t = sum != 0 ? static_cast<Real>(weighted / sum) * ray.inverse_square
               : dot(ray.direction, a) * ray.inverse_square;
  return true;
}

// Calls act(t, front) for each hit with the primitive at a t > 0, in their order along the ray: a triangle
// has at most one, a sphere or a cone two, or one where only the inside is visible. `front`: the front is
// met, of a sphere or a cone the outside; where only the inside is visible that is the front. Of a triangle
// by the half-open rule it is the side that the moved point sees, whose sum over a closed mesh is right;
// for a sliver that may not be the side that is met.
template <unsigned kinds, class TestRay, class Stored, class From, class Act>
MASU_HD inline void each_hit(const SceneView<Stored>& scene, const TestRay& ray, PrimitiveIndex primitive,
                             const From& from, EdgeRule rule, const Act& act) {
  using Real = typename TestRay::Real;
  if (primitive < scene.triangle_count) {
    const WatertightRay<Real> watertight = prepare_watertight(ray);
    const Triangle<Stored> triangle = from.triangle();
    Real t = 0;
    bool front = false, met = false;
    if (rule == EdgeRule::half_open) {
      met = crosses(watertight, triangle, t, front);
    } else if (intersect(watertight, triangle, t)) {
      front = meets_front(ray.direction, triangle);
      met = true;
    }
    if (met && t > 0) act(t, front);
    return;
  }
  const std::uint32_t sphere = primitive - scene.triangle_count;
  if (sphere < scene.sphere_count) {
    const Sphere<Stored> record = from.sphere();
    Real enter, leave;
    if (!intersect_line(ray, record, enter, leave)) return;
    const bool inside_out = record.radius < 0;
    if (!inside_out && enter > 0) act(enter, true);
    if (leave > 0) act(leave, inside_out);
    return;
  }
  each_hit<(kinds & with_tapers) != 0>(ray, from.cone(), [&](Real t, bool front) {
    if (t > 0) act(t, front);
    return false;
  });
}

} // namespace masu
