// A ray and what it hits.
#pragma once

#include "libscene/primitives.h"

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
MASU_HD inline Vec3<Real> without_traces(const Vec3<Real>& direction) {
  const Real least = largest_magnitude(direction) * (RealTraits<Real>::unit_roundoff / 256);
  return {std::abs(direction.x) < least ? 0 : direction.x, std::abs(direction.y) < least ? 0 : direction.y,
          std::abs(direction.z) < least ? 0 : direction.z};
}

// What all tests of one ray share, with which they lose no hit: the ray of `robust` and `double` arithmetic
// (textbook.h has that of `fast`). across1 and across2 span the plane across the ray.
template <class Real_>
struct RayFrame {
  using Real = Real_;
  Vec3<Real> origin, direction;
  Vec3<Real> across1, across2;
  Real inverse_square; // 1 / |direction|²
};

// across1 is exact: two of the direction's own components, swapped, the smallest left out. So the plane
// deviates from perpendicular by no more than across2's rounding.
template <class Real>
MASU_HD inline void prepare(RayFrame<Real>& ray, const Vec3<Real>& origin, const Vec3<Real>& along) {
  const Vec3<Real> direction = without_traces(along);
  const Real x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
  Vec3<Real> across{};
  if (x <= y && x <= z) {
    across = {0, direction.z, -direction.y};
  } else if (y <= z) {
    across = {-direction.z, 0, direction.x};
  } else {
    across = {direction.y, -direction.x, 0};
  }
  ray = {origin, direction, across, cross(direction, across), Real(1) / dot(direction, direction)};
}

// A hit as of the ray from where it enters the scene's bounds (clip.h): `hit.t` counts from that ray's
// origin, `skipped` is the t before it. Primitive no_primitive where nothing is hit; then t is the whole
// ray's t_max. TestRay: RayFrame<Real> or TextbookRay.
template <class TestRay>
struct NearHit {
  using Real = typename TestRay::Real;
  TestRay ray;
  Hit<Real> hit;
  Real skipped;
};

template <class TestRay>
MASU_HD inline Hit<typename TestRay::Real> seen_from_origin(const NearHit<TestRay>& near) {
  if (near.hit.primitive == no_primitive) return near.hit;
  return {near.hit.t + near.skipped, near.hit.primitive};
}

} // namespace masu
