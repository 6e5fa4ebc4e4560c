// A ray from outside starts where it enters the scene's bounds.
//
// So arithmetic on the ray never sees coordinates larger than the scene's, however far off the eye is; and it
// doesn't depend on the grid.
#pragma once

#include "libscene/box.h"
#include "libscene/ray.h"

namespace masu {

// The part of `ray` from where it enters `box` on. `skipped` is the t from the old origin to the new; t_max
// is less it.
template <class Real>
struct ClippedRay {
  Ray<Real> ray;
  Vec3<Real> inverse; // of the direction, component by component
  Real skipped;
};

// Whether the ray is in the box between `enter` and `leave`; leave is rounded up by more than rounding can
// hide (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013), and so enter down.
template <class Real>
MASU_HD inline bool crosses(const Box<Real>& box, const Ray<Real>& ray, const Vec3<Real>& inverse,
                            Real& enter) {
  constexpr Real slack = 8 * RealTraits<Real>::unit_roundoff;
  constexpr Real infinity = static_cast<Real>(INFINITY);
  Real leave = ray.t_max;
  enter = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Real from = ray.origin[axis];
    const Real t0 = (box.min[axis] - from) * inverse[axis], t1 = (box.max[axis] - from) * inverse[axis];
    // All along the box's side, or never beside it.
    const bool runs = std::abs(inverse[axis]) < infinity;
    const bool beside = from < box.min[axis] || from > box.max[axis];
    enter = larger(enter, runs ? smaller(t0, t1) : beside ? infinity : -infinity);
    leave = smaller(leave, runs ? larger(t0, t1) * (1 + slack) : infinity);
  }
  enter = enter * (1 - slack);
  return enter <= leave;
}

// False when the ray misses the box. The new origin is rounded once a coordinate: it stays on the ray to an
// ulp of the box's coordinates. It is held back by the entry's own rounding, and so may lie before the box;
// from very far off the entry is coarse, and is looked for once more from nearby.
template <class Real>
MASU_HD inline bool clip(const Ray<Real>& ray, const Box<Real>& box, ClippedRay<Real>& clipped) {
  const Vec3<Real> d = ray.direction;
  clipped = {ray, {1 / d.x, 1 / d.y, 1 / d.z}, 0};
  const Real far = 256 * largest_magnitude(box);
  for (bool again = true; again;) {
    Real enter;
    if (!crosses(box, clipped.ray, clipped.inverse, enter)) return false;
    clipped.ray.origin = fused(d, enter, clipped.ray.origin);
    again = clipped.skipped == 0 && enter * largest_magnitude(d) > far;
    clipped.skipped += enter;
    clipped.ray.t_max -= enter;
  }
  return true;
}

} // namespace masu
