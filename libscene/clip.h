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
  Real skipped;
};

// False when the ray misses the box: by more than rounding can hide, after Ize, "Robust BVH Ray Traversal",
// JCGT 2(2), 2013. From very far off the entry is coarse, and so is held back and looked for once more from
// nearby. The new origin is rounded once a coordinate: it stays on the ray to an ulp of the box's
// coordinates.
template <class Real>
MASU_HD inline bool clip(const Ray<Real>& ray, const Box<Real>& box, ClippedRay<Real>& clipped) {
  clipped = {ray, 0};
  constexpr Real slack = 8 * RealTraits<Real>::unit_roundoff;
  for (int round = 0; round < 2; ++round) {
    if (contains(box, clipped.ray.origin)) break;
    Real enter = 0, leave = clipped.ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const Real from = clipped.ray.origin[axis], towards = clipped.ray.direction[axis];
      if (std::abs(towards) < RealTraits<Real>::smallest_normal * 8) {
        if (from < box.min[axis] || from > box.max[axis]) return false;
        continue;
      }
      const Real inverse = 1 / towards;
      const Real t0 = (box.min[axis] - from) * inverse, t1 = (box.max[axis] - from) * inverse;
      enter = larger(enter, smaller(t0, t1));
      leave = smaller(leave, larger(t0, t1) * (1 + slack));
    }
    enter = enter * (1 - slack);
    if (!(enter <= leave)) return false;
    clipped.ray.origin = fused(clipped.ray.direction, enter, clipped.ray.origin);
    clipped.skipped += enter;
    clipped.ray.t_max -= enter;
  }
  return true;
}

} // namespace masu
