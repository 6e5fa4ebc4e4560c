// Scenes from arrays: of vertices and indices, spheres, cones.
#pragma once

#include "libscene/base/progress_monitor.h"
#include "libscene/mesh/triangle_area.h"
#include "libscene/scene.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>

namespace masu {

// An object: triangles between vertices.
struct IndexedMesh {
  std::size_t vertices = 0, triangles = 0;
  const float* floats = nullptr; // three per vertex; or
  const double* doubles = nullptr;
  const std::uint32_t* indices = nullptr; // three per triangle; null: vertices follow one another
  Vec3f color{0.8F, 0.8F, 0.8F};          // of the matte material

  MASU_ALWAYS_INLINE std::size_t index(std::size_t corner) const {
    return indices != nullptr ? indices[corner] : corner;
  }
  MASU_ALWAYS_INLINE Vec3d vertex(std::size_t i) const {
    if (floats != nullptr) return cast<double>(Vec3f{floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]});
    return {doubles[3 * i], doubles[3 * i + 1], doubles[3 * i + 2]};
  }
};

// Triangles in the order of meshes and indices, all of them: one of which two corners coincide keeps its
// number, and can't be hit (points.h). They are made when they are asked for, and nowhere in memory.
class MeshTriangles {
public:
  MeshTriangles() = default;
  // The meshes must outlive it. Throws Error(usage) for an index that is no vertex's, and a coordinate that
  // isn't finite or beyond 1e100.
  MeshTriangles(std::span<const IndexedMesh> meshes, const ProgressMonitor* progress);

  std::size_t size() const { return ends_.empty() ? 0 : ends_.back(); }
  MASU_ALWAYS_INLINE SceneTriangle operator[](std::size_t i) const {
    const std::size_t m = meshes_.size() == 1 ? 0 : mesh_of(i);
    const IndexedMesh& mesh = meshes_[m];
    const std::size_t first = 3 * (i - (m > 0 ? ends_[m - 1] : 0));
    const Vec3d a = mesh.vertex(mesh.index(first)), b = mesh.vertex(mesh.index(first + 1)),
                c = mesh.vertex(mesh.index(first + 2));
    if (!has_distinct_corners(a, b, c)) return {place_, m, place_, m, place_, no_normals};
    return {a, m, b, m, c, no_normals};
  }
  // Of all; empty where there are none.
  const Boxd& box() const { return box_; }
  // Of those that have a surface the least one's longest side along an axis; infinite where there are none.
  double least_extent() const { return least_extent_; }

private:
  std::size_t mesh_of(std::size_t i) const {
    return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), i) - ends_.begin());
  }

  std::span<const IndexedMesh> meshes_;
  std::vector<std::size_t> ends_; // by mesh, of its triangles
  Vec3d place_{0, 0, 0};          // of those without a surface
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

// First all triangles, of meshes that must outlive the scene; then all spheres, then all cones; objects are
// numbered in that order. Camera and light are automatic. Throws Error(usage, place, …) as MeshTriangles(),
// for a sphere or cone without a surface, and for more primitives than a scene may have.
using ArrayScene = SceneOf<MeshTriangles>;
ArrayScene scene_of(std::span<const IndexedMesh> meshes, std::span<const SphereArray> spheres = {},
                    std::span<const ConeArray> cones = {}, const ProgressMonitor* progress = nullptr);

} // namespace masu
