// Scenes from arrays of vertices and indices.
#pragma once

#include "libscene/scene.h"

#include <functional>
#include <span>

namespace masu {

// An object: the triangles between vertices, three indices each.
struct IndexedMesh {
  std::size_t vertices = 0, triangles = 0;
  std::function<Vec3d(std::size_t)> vertex;
  const std::uint32_t* indices = nullptr;
  Vec3f color{0.8F, 0.8F, 0.8F}; // of the matte material
};

// Triangles in the order of meshes and indices, all of them: one without area (triangulate.h) keeps its
// number, and can't be hit (points.h). Camera and light are automatic. Throws Error(usage, "meshes", …) for
// an index that is no vertex's, a coordinate that isn't finite or beyond 1e100, and more triangles than a
// scene may have.
Scene scene_of(std::span<const IndexedMesh> meshes);

} // namespace masu
