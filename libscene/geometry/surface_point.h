// A place on a surface, as shading needs it.
#pragma once

#include "libscene/geometry/vector.h"

#include <cstdint>

namespace masu {

template <class Real>
struct SurfacePoint {
  Vec3<Real> position;
  Vec3<Real> normal;  // of unit length, on the front's side, perpendicular to the surface
  Vec3<Real> shading; // the same, or interpolated from corner normals
  Real error;         // rays that leave start this far off the surface
  std::uint32_t material;
};

} // namespace masu
