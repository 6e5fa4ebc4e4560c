// Ray and primitive by number, compiled for the kinds that a scene holds: no cone code runs where there is no
// cone.
#pragma once

#include "libscene/fetch.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/sphere.h"
#include "libscene/geometry/textbook.h"
#include "libscene/geometry/triangle.h"
#include "libscene/scene_view.h"

namespace masu {

// A set of primitive kinds. Cylinders are cones; with_tapers: there are cones that aren't cylinders.
inline constexpr unsigned with_triangles = 1, with_spheres = 2, with_cones = 4, with_tapers = 8,
                          with_all_kinds = 15;

// Whether the ray meets the primitive at a t > 0, and where. `counts` is told which test was run. What kind
// of ray it is says by which formulas.
template <unsigned kinds, class TestRay, class Stored, class Counts>
MASU_HD inline bool intersect(const SceneView<Stored>& scene, const TestRay& ray, PrimitiveIndex primitive,
                              typename TestRay::Real& t, Counts& counts) {
  if constexpr ((kinds & with_triangles) != 0) {
    if (kinds == with_triangles || primitive < scene.triangle_count) {
      counts.triangle_test();
      return intersect(ray, fetched(scene.triangles + primitive), t) && t > 0;
    }
  }
  const std::uint32_t sphere = primitive - scene.triangle_count;
  if constexpr ((kinds & with_spheres) != 0) {
    if ((kinds & with_cones) == 0 || sphere < scene.sphere_count) {
      counts.sphere_test();
      return intersect(ray, fetched(scene.spheres + sphere), t);
    }
  }
  if constexpr ((kinds & with_cones) != 0) {
    counts.cone_test();
    return intersect<(kinds & with_tapers) != 0>(ray, fetched(scene.cones + (sphere - scene.sphere_count)),
                                                 t);
  }
  return false;
}

template <class Stored>
MASU_HD inline Surface surface_of(const SceneView<Stored>& scene, PrimitiveIndex primitive) {
  if (primitive < scene.triangle_count) {
    const Triangle<Stored>& t = scene.triangles[primitive];
    return {static_cast<std::uint32_t>(t.object), static_cast<std::uint32_t>(t.material)};
  }
  const std::uint32_t sphere = primitive - scene.triangle_count;
  return sphere < scene.sphere_count ? scene.sphere_surfaces[sphere]
                                     : scene.cone_surfaces[sphere - scene.sphere_count];
}

} // namespace masu
