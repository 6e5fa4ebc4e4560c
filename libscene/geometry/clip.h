// Moves the origin of a ray from outside to where it enters the scene's bounds.
//
// So no coordinate in later arithmetic is larger than the scene's, however far away the camera is. The new
// origin depends on neither the grid nor t_min and t_max: a hit's t is the same, to the bit, whatever the
// limits, and it is that t which is compared with them.
#pragma once

#include "libscene/geometry/box.h"
#include "libscene/geometry/margin.h"
#include "libscene/geometry/ray.h"

namespace masu {

// A ray from where it enters a box. `skipped` is t from the old origin to the new one. A hit at t of this
// ray's is reported at t + skipped; its limits are such that t_min < t < t_max just where that sum, rounded,
// is between the old ray's.
template <class Real>
struct ClippedRay {
  Ray<Real> ray;
  Vec3<Real> inverse; // of the direction, component by component; finite
  Real skipped;
};

// The slab test: whether the ray is in the box between `enter` and some larger t. The exit is enlarged, and
// `enter` reduced, by more than their rounding errors (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013).
template <class Real>
MASU_HD inline bool crosses(const Box<Real>& box, const Ray<Real>& ray, const Vec3<Real>& inverse,
                            Real& enter) {
  constexpr Real slack = 8 * RealTraits<Real>::unit_roundoff;
  const Vec3<Real> t0 = (box.min - ray.origin) * inverse, t1 = (box.max - ray.origin) * inverse;
  const Real from =
      fast_max(fast_max(Real(0), fast_min(t0.x, t1.x)), fast_max(fast_min(t0.y, t1.y), fast_min(t0.z, t1.z)));
  const Real leave = fast_min(fast_max(t0.x, t1.x), fast_min(fast_max(t0.y, t1.y), fast_max(t0.z, t1.z)));
  enter = from * (1 - slack);
  return enter <= leave * (1 + slack) && enter <= ray.t_max;
}

// The least x >= 0 for which x + skipped, rounded, is at least t.
template <class Real>
MASU_HD inline Real first_reaching(Real t, Real skipped) {
  // What rounds up to t is less than t by half the distance to the number below it. Two roundings: the x that
  // is looked for is at most two numbers away.
  const Real half_gap = (t - next_below(t)) / 2;
  Real x = next_below(next_below(max((t - skipped) - half_gap, Real(0))));
  for (int steps = 0; steps < 4; ++steps) // without a branch, which would take registers from all of a kernel
    x = x + skipped < t ? next_above(x) : x;
  return x;
}
// The limits of a clipped ray (see there) for those of the ray that was clipped.
template <class Real>
MASU_HD inline Real clipped_t_min(Real t_min, Real skipped) {
  if (!(skipped > 0)) return t_min;
  return t_min < skipped ? 0 : next_below(first_reaching(next_above(t_min), skipped));
}
template <class Real>
MASU_HD inline Real clipped_t_max(Real t_max, Real skipped) {
  return skipped > 0 && t_max < RealTraits<Real>::largest ? first_reaching(t_max, skipped) : t_max;
}

// Whether the ray can't meet anything that lies `padding` or more inside the box: it starts past the far face
// of an axis, less `padding`, as a ray does that leaves an outermost surface of the scene.
template <class Real>
MASU_HD inline bool departs(const Box<Real>& box, const Ray<Real>& ray, Real padding) {
  const Vec3<Real> above = ray.origin - box.min, below = box.max - ray.origin, d = ray.direction;
  return fast_min(d.x > 0 ? below.x : above.x,
                  fast_min(d.y > 0 ? below.y : above.y, d.z > 0 ? below.z : above.z)) < padding;
}

// Each clip leaves less than 2^-20 (float) or 2^-49 (double) of the way to the box. Origins and scenes differ
// by at most 1e25 (1e195), for which 5 (14) are enough.
inline constexpr int most_clips = 16;

// As clip(), but t_min, which is only needed once something is hit, is left to the caller: 0.
//
// Because `enter` is reduced by its rounding error, the new origin may lie before the box. From far away that
// error is large, and another clip from there removes it, until the way is at most 256 times the box's
// largest coordinate. Were it longer, t would be too coarse to tell apart what the ray meets: hits would tie
// that don't, and results depend on the grid. Each clip rounds each coordinate once. So the new origin is on
// the ray to an ulp of the box's coordinates, as long as the first clip's error is no larger than the box: up
// to 2^23 times (double: 2^52) its coordinates away. From farther away the ray is moved aside, unless it is
// parallel to an axis.
//
// A ray that after all clips is still far away misses. It has a component so small that its inverse is
// clamped.
template <class Real>
MASU_HD inline bool clip_but_t_min(const Ray<Real>& ray, const Box<Real>& box, ClippedRay<Real>& clipped) {
  const Vec3<Real> d = ray.direction;
  clipped = {
      {ray.origin, 0, d, ray.t_max}, {finite_inverse(d.x), finite_inverse(d.y), finite_inverse(d.z)}, 0};
  const Real largest = largest_magnitude(box), far = 256 * largest;
  // The box's padding, less the rounding of the box itself.
  constexpr Real padding = (2 * margin_roundings - 16) * RealTraits<Real>::unit_roundoff;
  if (departs(box, ray, padding * largest)) return false;
#ifdef __CUDA_ARCH__
#pragma unroll 1 // one clip is nearly always enough
#endif
  for (int clips = 0; clips < most_clips; ++clips) {
    Real enter;
    if (!crosses(box, clipped.ray, clipped.inverse, enter)) return false;
    clipped.ray.origin = fma(d, enter, clipped.ray.origin);
    clipped.skipped += enter;
    if (!(enter * largest_magnitude(d) > far)) {
      clipped.ray.t_max = clipped_t_max(ray.t_max, clipped.skipped);
      return clipped.ray.t_max > 0;
    }
  }
  return false;
}

// `box`: a scene's padded bounds (margin.h). False when the ray misses the box or departs from the bounds.
template <class Real>
MASU_HD inline bool clip(const Ray<Real>& ray, const Box<Real>& box, ClippedRay<Real>& clipped) {
  const bool meets = clip_but_t_min(ray, box, clipped);
  clipped.ray.t_min = clipped_t_min(ray.t_min, clipped.skipped);
  return meets;
}

} // namespace masu
