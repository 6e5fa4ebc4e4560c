// Pointers to a scene's arrays, in host or device memory, for tracing and for shading. Passed by value.
#pragma once

#include "libscene/scene.h"

namespace masu {

// Of a triangle in leaf order: where it lies, and its object.
struct TrianglePlace {
  std::uint32_t leaf, object;
};

template <class Stored>
struct SceneView {
  // In their own order; or on a GPU those of a hierarchy's leaves, in the order of its references, with their
  // own numbers as their objects: then nothing but that hierarchy is traced.
  const Triangle<Stored>* triangles;
  const TrianglePlace* places; // of each triangle in leaf order; null: they are in their own
  const CornerNormals<Stored>* normals;
  const Sphere<Stored>* spheres;
  const Surface* sphere_surfaces;
  const Cone<Stored>* cones;
  const Surface* cone_surfaces;
  const std::uint32_t* faces; // as Scene has them; null: each triangle is its own
  const Material* materials;

  std::uint32_t triangle_count, sphere_count, cone_count;

  // Bounds of all primitives, padded (libscene/geometry/margin.h); rays from outside are clipped to it.
  Box<Stored> clip;

  MASU_HD std::uint32_t primitive_count() const { return triangle_count + sphere_count + cone_count; }
  // The record of a triangle, in either order.
  MASU_HD const Triangle<Stored>* triangle(PrimitiveIndex index) const {
    return triangles + (places != nullptr ? places[index].leaf : index);
  }
};

// What surfaces are lit by.
template <class Stored>
struct Lighting {
  const Light<Stored>* lights;
  std::uint32_t light_count;
  Vec3f background;
  float ambient;
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
    act(widened(*scene.triangle(index)));
  } else if (sphere < scene.sphere_count) {
    act(widened(scene.spheres[sphere]));
  } else {
    act(widened(scene.cones[sphere - scene.sphere_count]));
  }
}

} // namespace masu
