// Rays and hits.
#pragma once

#include "libscene/geometry/primitives.h"

namespace masu {

// Points origin + t·direction with t_min < t < t_max, in the order in which lists of rays store them. The
// direction isn't zero; t is in units of its length. t_min isn't negative.
template <class Real>
struct alignas(16) Ray {
  Vec3<Real> origin;
  Real t_min;
  Vec3<Real> direction;
  Real t_max;
};
static_assert(sizeof(Ray<float>) == 32 && sizeof(Ray<double>) == 64);

template <class Real>
MASU_HD inline Ray<Real> unbounded_ray(const Vec3<Real>& origin, const Vec3<Real>& direction) {
  return {origin, 0, direction, RealTraits<Real>::largest};
}

// A miss has the ray's t_max and no_primitive.
template <class Real>
struct Hit {
  Real t;
  PrimitiveIndex primitive;
};

// A miss as it is reported of a ray in a list.
template <class Real = float>
MASU_HD constexpr Hit<Real> no_hit() {
  return {static_cast<Real>(INFINITY), no_primitive};
}

// Ties go to the lowest primitive index: so results don't depend on the order of tests.
template <class Real>
MASU_HD inline bool is_nearer(Real t, PrimitiveIndex primitive, const Hit<Real>& than) {
  return (t < than.t) | ((t == than.t) & (primitive < than.primitive));
}

// Sets components to zero that are so small that they can't move the ray by a hundredth of a rounding on its
// way through the scene: then no product with them underflows, and what is parallel to the ray is so
// exactly.
template <class Real>
MASU_HD inline Vec3<Real> flush_tiny_components(const Vec3<Real>& direction) {
  const Real limit = largest_magnitude(direction) * (RealTraits<Real>::unit_roundoff / 256);
  return {std::abs(direction.x) < limit ? 0 : direction.x, std::abs(direction.y) < limit ? 0 : direction.y,
          std::abs(direction.z) < limit ? 0 : direction.z};
}

// A ray with what is computed once for all its intersection tests, of `robust` and `double` precision
// (textbook.h has the ray of `fast`).
template <class Real_>
struct PreparedRay {
  using Real = Real_;
  Vec3<Real> origin, direction;
  Real inverse_square; // 1 / |direction|²
};

// The same with two vectors that span the plane perpendicular to the ray, which every triangle test needs:
// worth their registers when many triangles are tested.
template <class Real_>
struct WatertightRay : PreparedRay<Real_> {
  Vec3<Real_> across1, across2;
};

// across1 is exact: the direction's two larger components, swapped, one negated. So the plane deviates from
// perpendicular only by the rounding of across2.
template <class Real>
MASU_HD inline WatertightRay<Real> prepare_watertight(const PreparedRay<Real>& ray) {
  const Vec3<Real> d = ray.direction;
  const Real x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const bool no_x = (x <= y) & (x <= z), no_y = !no_x & (y <= z);
  const Vec3<Real> across{no_x   ? 0
                          : no_y ? -d.z
                                 : d.y,
                          no_x   ? d.z
                          : no_y ? 0
                                 : -d.x,
                          no_x   ? -d.y
                          : no_y ? d.x
                                 : 0};
  return {ray, across, cross(d, across)};
}
template <class Real>
MASU_HD inline const WatertightRay<Real>& prepare_watertight(const WatertightRay<Real>& ray) {
  return ray;
}

template <class Real>
MASU_HD inline void prepare(PreparedRay<Real>& ray, const Vec3<Real>& origin, const Vec3<Real>& along) {
  const Vec3<Real> direction = flush_tiny_components(along);
  ray = {origin, direction, fast_divide(Real(1), dot(direction, direction))};
}
template <class Real>
MASU_HD inline void prepare(WatertightRay<Real>& ray, const Vec3<Real>& origin, const Vec3<Real>& along) {
  PreparedRay<Real> line{};
  prepare(line, origin, along);
  ray = prepare_watertight(line);
}

// A hit of a clipped ray (clip.h): `hit.t` is relative to the clipped ray's origin, `skipped` is t from the
// original origin to it. For a miss `hit.t` is t_max of the original ray. TestRay: PreparedRay<Real>,
// WatertightRay<Real> or TextbookRay.
template <class TestRay>
struct NearHit {
  using Real = typename TestRay::Real;
  TestRay ray;
  Hit<Real> hit;
  Real skipped;
};

// With t from the original ray's origin.
template <class TestRay>
MASU_HD inline Hit<typename TestRay::Real> relative_to_origin(const NearHit<TestRay>& near) {
  if (near.hit.primitive == no_primitive) return near.hit;
  return {near.hit.t + near.skipped, near.hit.primitive};
}

} // namespace masu
