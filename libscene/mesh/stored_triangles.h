// Triangles of a scene as they are stored, made of vertices in the world, by host and device alike.
#pragma once

#include "libscene/local_origin.h"
#include "libscene/mesh/triangle_area.h"
#include "libscene/passes/executor.h"
#include "libscene/scene_view.h"

namespace masu {

// Vertices in the world, where the executor's code sees them, and triangles between them.
template <class Number>
struct WorldVertices {
  const Number* numbers;        // three per vertex
  const std::uint32_t* indices; // three per triangle, each a vertex's; null: vertices follow one another
  Vec3d origin;                 // the scene's

  MASU_HD Vec3d corner(std::uint64_t i) const {
    const Number* const v = numbers + 3 * (indices != nullptr ? std::uint64_t{indices[i]} : i);
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  }
  // Triangle i's corners.
  MASU_HD Triangle<double> face(std::uint64_t i) const {
    return {corner(3 * i), 0, corner(3 * i + 1), 0, corner(3 * i + 2), no_normals};
  }
};

template <class Stored>
MASU_HD Vec3<Stored> stored_point(const Vec3d& origin, const Vec3d& point) {
  return cast<Stored>(relative_to(origin, point));
}
template <class Stored>
MASU_HD Triangle<Stored> stored_triangle(const Vec3d& origin, const Triangle<double>& face) {
  return cast<Stored>(Triangle<double>{relative_to(origin, face.a), face.object, relative_to(origin, face.b),
                                       face.material, relative_to(origin, face.c), face.normals});
}

// Of meshes whose arrays follow one another (MeshTriangles, indexed_mesh.h), as they are stored.
template <class Stored, class Number>
struct StoredTriangles {
  WorldVertices<Number> vertices;
  const std::uint64_t* begins; // of so many meshes
  std::size_t meshes;
  Vec3d place; // of triangles without a surface

  MASU_HD Triangle<Stored> operator()(std::uint64_t i) const {
    Triangle<double> face = vertices.face(i);
    if (!has_distinct_corners(face.a, face.b, face.c)) face.a = face.b = face.c = place;
    const std::uint64_t mesh = meshes == 1 ? 0 : owner_of(begins, meshes, i);
    face.object = face.material = static_cast<typename Triangle<double>::Tag>(mesh);
    return stored_triangle<Stored>(vertices.origin, face);
  }
};

// The view of a scene in host memory whose triangles are made from meshes whenever they are read.
template <class Stored, class Number>
struct MeshesView {
  SceneView<Stored> others; // without triangles
  StoredTriangles<Stored, Number> triangles;
  std::uint32_t triangle_count = others.triangle_count;

  std::uint32_t primitive_count() const { return others.primitive_count(); }
};

// As of a SceneView.
template <class Stored, class Number, class Act>
void with_primitive(const MeshesView<Stored, Number>& scene, PrimitiveIndex index, const Act& act) {
  if (index < scene.triangle_count)
    act(widened(scene.triangles(index)));
  else
    with_primitive(scene.others, index, act);
}

} // namespace masu
