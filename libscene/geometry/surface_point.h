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

// Off the surface, on the side that the direction points to.
template <class Real>
MASU_HD inline Vec3<Real> leaving(const SurfacePoint<Real>& point, const Vec3<Real>& direction) {
  return fma(point.normal, dot(direction, point.normal) < 0 ? -point.error : point.error, point.position);
}

} // namespace masu
