// Pointers to a scene's arrays, in host or device memory, for tracing. Passed by value.
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
  const std::uint32_t* faces; // as Scene has them; null: each triangle is its own
  const Material* materials;
  const Light<Stored>* lights;

  std::uint32_t triangle_count, sphere_count, cone_count, light_count;

  // Bounds of all primitives, padded (libscene/geometry/margin.h); rays from outside are clipped to it.
  Box<Stored> clip;
  Vec3f background;
  float ambient;

  MASU_HD std::uint32_t primitive_count() const { return triangle_count + sphere_count + cone_count; }
};

// Kernels take it by value. Of a larger one nvcc 13 keeps the address in a register, and loads its pointers
// in the inner loops: 3 % of the time of lists.
static_assert(sizeof(SceneView<float>) <= 128);

// How many records there are that others point to.
struct SceneCounts {
  std::uint64_t objects, normals, materials;
};

// Calls act(the primitive of this index, in double).
template <class Stored, class Act>
MASU_HD void with_primitive(const SceneView<Stored>& scene, PrimitiveIndex index, const Act& act) {
  const std::uint32_t sphere = index - scene.triangle_count;
  if (index < scene.triangle_count) {
    act(widened(scene.triangles[index]));
  } else if (sphere < scene.sphere_count) {
    act(widened(scene.spheres[sphere]));
  } else {
    act(widened(scene.cones[sphere - scene.sphere_count]));
  }
}

} // namespace masu
