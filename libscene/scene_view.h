// A scene as tracing sees it: where its arrays lie, on the host or on the device. Passed by value.
#pragma once

#include "libscene/scene.h"

namespace masu {

template <class Stored>
struct SceneView {
  const Triangle<Stored>* triangles;
  const CornerNormals<Stored>* normals;
  const Sphere<Stored>* spheres;
  const Surface* sphere_surfaces;
  const Cone<Stored>* cones;
  const Surface* cone_surfaces;
  const Material* materials;
  const Light<Stored>* lights;

  std::uint32_t triangle_count, normals_count, sphere_count, cone_count, material_count, light_count;

  // Of all primitives, grown by the padding of libscene/geometry/margin.h; what a ray from outside is clipped
  // to.
  Box<Stored> clip;
  Vec3f background;
  float ambient;

  MASU_HD std::uint32_t primitive_count() const { return triangle_count + sphere_count + cone_count; }
};

// Calls act(the primitive with this number, in double).
template <class Stored, class Act>
MASU_HD void with_primitive(const SceneView<Stored>& scene, PrimitiveIndex number, const Act& act) {
  const std::uint32_t sphere = number - scene.triangle_count;
  if (number < scene.triangle_count) {
    act(widened(scene.triangles[number]));
  } else if (sphere < scene.sphere_count) {
    act(widened(scene.spheres[sphere]));
  } else {
    act(widened(scene.cones[sphere - scene.sphere_count]));
  }
}

} // namespace masu
