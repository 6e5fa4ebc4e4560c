// A point on a surface with what shading needs.
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

} // namespace masu
