// A ray and what it hits.
#pragma once

#include "libscene/geometry/primitives.h"

namespace masu {

// Points origin + t·direction with 0 < t < t_max. The direction isn't zero; t counts in its length.
template <class Real>
struct Ray {
  Vec3<Real> origin, direction;
  Real t_max;
};

// t is t_max of the ray, and primitive no_primitive, where nothing is hit.
template <class Real>
struct Hit {
  Real t;
  PrimitiveIndex primitive;
};

// The nearer hit; of equally near ones that of the lowest primitive, so that the order of tests never shows.
template <class Real>
MASU_HD inline bool is_nearer(Real t, PrimitiveIndex primitive, const Hit<Real>& than) {
  return (t < than.t) | ((t == than.t) & (primitive < than.primitive));
}

// The direction without components so small that they can't move the ray by a hundredth of a rounding on its
// way through the scene: what lies exactly along the ray stays so, and no product with them underflows.
template <class Real>
MASU_HD inline Vec3<Real> flush_tiny_components(const Vec3<Real>& direction) {
  const Real least = largest_magnitude(direction) * (RealTraits<Real>::unit_roundoff / 256);
  return {std::abs(direction.x) < least ? 0 : direction.x, std::abs(direction.y) < least ? 0 : direction.y,
          std::abs(direction.z) < least ? 0 : direction.z};
}

// What all tests of one ray share, with which they lose no hit: the ray of `robust` and `double` arithmetic
// (textbook.h has that of `fast`).
template <class Real_>
struct PreparedRay {
  using Real = Real_;
  Vec3<Real> origin, direction;
  Real inverse_square; // 1 / |direction|²
};

// The same with two vectors that span the plane across the ray: what each test of a triangle needs, and so
// worth its registers where there are many.
template <class Real_>
struct WatertightRay : PreparedRay<Real_> {
  Vec3<Real_> across1, across2;
};

// across1 is exact: two of the direction's own components, swapped, the smallest left out. So the plane
// deviates from perpendicular by no more than across2's rounding.
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

// A hit as of the ray from where it enters the scene's bounds (clip.h): `hit.t` counts from that ray's
// origin, `skipped` is the t before it. Primitive no_primitive where nothing is hit; then t is the whole
// ray's t_max. TestRay: PreparedRay<Real>, WatertightRay<Real>
// or TextbookRay.
template <class TestRay>
struct NearHit {
  using Real = typename TestRay::Real;
  TestRay ray;
  Hit<Real> hit;
  Real skipped;
};

template <class TestRay>
MASU_HD inline Hit<typename TestRay::Real> relative_to_origin(const NearHit<TestRay>& near) {
  if (near.hit.primitive == no_primitive) return near.hit;
  return {near.hit.t + near.skipped, near.hit.primitive};
}

} // namespace masu
