// Ray and sphere, after Haines, Günther & Akenine-Möller, "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems, chapter 7, 2019: the discriminant is computed from the vector between
// centre and ray, without cancellation however far away the origin is.
#pragma once

#include "libscene/geometry/ray.h"

namespace masu {

// Whether the ray's line meets the sphere; then sets where it enters and leaves it, which may be negative.
template <class Real, class Stored>
MASU_HD inline bool intersect_line(const PreparedRay<Real>& ray, const Sphere<Stored>& sphere, Real& enter,
                                   Real& leave) {
  const Real radius = static_cast<Real>(sphere.radius);
  const Vec3<Real> to_center = cast<Real>(sphere.center) - ray.origin;
  const Real nearest = dot(to_center, ray.direction) * ray.inverse_square;
  const Vec3<Real> off = fma(ray.direction, -nearest, to_center);
  const Real discriminant = difference_of_products(radius, radius, Real(1), dot(off, off));
  if (!(discriminant >= 0)) return false;
  const Real half_chord = std::sqrt(discriminant * ray.inverse_square);
  enter = nearest - half_chord;
  leave = nearest + half_chord;
  return true;
}

// Whether the ray meets the sphere at a t > t_min; then `t` is the nearest. With a negative radius only where
// it leaves the sphere counts.
template <class Real, class Stored>
MASU_HD inline bool intersect(const PreparedRay<Real>& ray, const Sphere<Stored>& sphere, Real t_min,
                              Real& t) {
  Real enter, leave;
  if (!intersect_line(ray, sphere, enter, leave)) return false;
  t = sphere.radius > 0 && enter > t_min ? enter : leave;
  return t > t_min;
}

} // namespace masu
