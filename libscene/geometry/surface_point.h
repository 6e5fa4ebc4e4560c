// A point on a surface with what shading needs, and where rays leave it.
#pragma once

#include "libscene/geometry/vector.h"

#include <cstdint>

namespace masu {

template <class Real>
struct SurfacePoint {
  Vec3<Real> position;
  Vec3<Real> normal;  // geometric normal: of unit length, on the front side
  Vec3<Real> shading; // shading normal: the same, or interpolated from corner normals
  Real error;         // the error bound: secondary rays start this far off the surface
  std::uint32_t material;
  bool is_flat; // what moves away from the surface doesn't come back to it
};

// The point's surroundings as shading needs them: everything turned to the viewer.
template <class Real>
struct Facing {
  Vec3<Real> normal, shading;
  bool front; // the ray meets the front
};

template <class Real>
MASU_HD inline Facing<Real> facing(const SurfacePoint<Real>& point, const Vec3<Real>& direction) {
  const bool front = dot(point.normal, direction) < 0;
  return {front ? point.normal : -point.normal,
          dot(point.shading, direction) < 0 ? point.shading : -point.shading, front};
}

// Off the surface, on the side that the direction, of any length, points to: a flat one is left along the
// ray, which so stays the same ray; by what would take more than about four times the error, and a curved
// one, along the normal.
template <class Real>
MASU_HD inline Vec3<Real> leaving(const SurfacePoint<Real>& point, const Vec3<Real>& direction) {
  const Real rise = dot(direction, point.normal), steep = std::abs(rise);
  const Real slide =
      point.is_flat ? fast_divide(point.error, fast_max(steep, largest_magnitude(direction) / 4)) : 0;
  const Real lift = fast_max(fma(-slide, steep, point.error), Real(0));
  return fma(direction, slide, fma(point.normal, rise < 0 ? -lift : lift, point.position));
}

} // namespace masu
