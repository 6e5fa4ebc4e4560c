// Scenes from arrays: of vertices and indices, spheres, cones.
#pragma once

#include "libscene/base/host_array.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/mesh/stored_triangles.h"
#include "libscene/mesh/vertices.h"
#include "libscene/scene.h"

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace masu {

// An object: triangles between vertices.
struct IndexedMesh {
  std::size_t vertices = 0, triangles = 0;
  const float* floats = nullptr; // three per vertex; or
  const double* doubles = nullptr;
  const std::uint32_t* indices = nullptr; // three per triangle; null: vertices follow one another
  Vec3f color{0.8F, 0.8F, 0.8F};          // of the matte material
};

// Triangles in the order of meshes and indices, all of them: one of which two corners coincide keeps its
// number, and can't be hit (triangle_area.h). They are made when they are asked for, from a copy of the
// meshes' arrays in one list, which copies of this share.
class MeshTriangles {
public:
  using Indices = HostArray<std::uint32_t>;

  MeshTriangles() = default;
  // Throws Error(usage) for an index that is no vertex's, a coordinate that isn't finite or beyond 1e100, and
  // more vertices than can be numbered.
  MeshTriangles(std::span<const IndexedMesh> meshes, const ProgressMonitor* progress);

  std::size_t size() const { return size_; }
  // Calls act(all of them as they are stored, relative to an origin: StoredTriangles).
  template <class Stored, class Act>
  auto as_stored(const Vec3d& origin, const Act& act) const {
    const auto of = [&]<class Number>(const Number* numbers) {
      return act(StoredTriangles<Stored, Number>{
          {numbers, vertices_.indices.data(), origin}, begins_.data(), begins_.size(), place_});
    };
    return vertices_.floats != nullptr ? of(vertices_.floats) : of(vertices_.doubles);
  }
  SceneTriangle operator[](std::size_t i) const {
    return as_stored<double>({}, [i](const auto& triangles) { return triangles(i); });
  }
  // Of all; empty where there are none.
  const Boxd& box() const { return box_; }
  // Of those that have a surface the least one's longest side along an axis; infinite where there are none.
  double least_extent() const { return least_extent_; }

  // What they are made from: all vertices, in doubles where a mesh has them, and indices, where a mesh's
  // vertices don't follow one another.
  const Vertices& vertices() const { return vertices_; }
  std::shared_ptr<const Indices> indices() const { return indices_; }

private:
  std::size_t size_ = 0;
  Vertices vertices_;                   // in
  std::shared_ptr<const void> numbers_; // and, where there are any,
  std::shared_ptr<const Indices> indices_;
  std::vector<std::uint64_t> begins_; // of each mesh the first triangle
  Vec3d place_{0, 0, 0};              // of triangles without a surface
  Boxd box_ = empty_box<double>();
  double least_extent_ = std::numeric_limits<double>::infinity();
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

// First all triangles, then all spheres, then all cones; objects are numbered in that order. Camera and light
// are automatic. Throws Error(usage, place, …) as MeshTriangles(), for a sphere or cone without a surface,
// and for more primitives than a scene may have.
using ArrayScene = SceneOf<MeshTriangles>;
ArrayScene scene_of(std::span<const IndexedMesh> meshes, std::span<const SphereArray> spheres = {},
                    std::span<const ConeArray> cones = {}, const ProgressMonitor* progress = nullptr);

} // namespace masu
