// Scenes from arrays: of vertices and indices, spheres, cones.
#pragma once

#include "libscene/base/progress_monitor.h"
#include "libscene/scene.h"

#include <functional>
#include <span>

namespace masu {

// An object: triangles between vertices.
struct IndexedMesh {
  std::size_t vertices = 0, triangles = 0;
  std::function<Vec3d(std::size_t)> vertex;
  const std::uint32_t* indices = nullptr; // three per triangle; null: vertices follow one another
  Vec3f color{0.8F, 0.8F, 0.8F};          // of the matte material
};

// An object: spheres or cones.
template <class Primitive>
struct PrimitiveArray {
  std::size_t count = 0;
  std::function<Primitive(std::size_t)> primitive;
  Vec3f color{0.8F, 0.8F, 0.8F};
};
using SphereArray = PrimitiveArray<Sphere<double>>;
using ConeArray = PrimitiveArray<Cone<double>>;

// Triangles in the order of meshes and indices, all of them: one of which two corners coincide keeps
// its number, and can't be hit (points.h). Then all spheres, then all cones; objects are numbered in that
// order. Camera and light are automatic. Throws Error(usage, place, …) for an index that is no vertex's, a
// coordinate that isn't finite or beyond 1e100, a sphere or cone without a surface, and more primitives than
// a scene may have.
Scene scene_of(std::span<const IndexedMesh> meshes, std::span<const SphereArray> spheres = {},
               std::span<const ConeArray> cones = {}, const ProgressMonitor* progress = nullptr);

} // namespace masu
