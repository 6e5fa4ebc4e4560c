// Random meshes as arrays, and the scene of their triangles, made one by one.
#pragma once

#include "libscene/mesh/indexed_mesh.h"
#include "stability/test_scene.h"

#include <algorithm>
#include <vector>

namespace masu {

struct MeshArrays {
  std::vector<float> floats;
  std::vector<double> doubles;
  std::vector<std::uint32_t> indices;
  std::size_t triangles = 0;

  std::size_t vertices() const { return (floats.size() + doubles.size()) / 3; }
  IndexedMesh view() const {
    return {vertices(), triangles, doubles.empty() ? floats.data() : nullptr,
            doubles.empty() ? nullptr : doubles.data(), indices.empty() ? nullptr : indices.data()};
  }
  Vec3d corner(std::size_t i) const {
    const std::size_t first = 3 * (indices.empty() ? i : indices[i]);
    if (doubles.empty()) return cast<double>(Vec3f{floats[first], floats[first + 1], floats[first + 2]});
    return {doubles[first], doubles[first + 1], doubles[first + 2]};
  }
};

inline std::vector<IndexedMesh> views_of(const std::vector<MeshArrays>& meshes) {
  std::vector<IndexedMesh> views;
  for (const MeshArrays& mesh : meshes)
    views.push_back(mesh.view());
  return views;
}

// Around a place that may be far away: of floats or doubles, indexed or not, some empty, some of whose
// triangles have no surface, with zeros of both signs and vertices that no triangle has.
inline std::vector<MeshArrays> random_meshes(Chance& chance, int most_triangles) {
  std::vector<MeshArrays> meshes(static_cast<std::size_t>(chance.whole(1, 5)));
  const Vec3d place = chance.in_cube(chance.one_of({0.0, 1.0, 1000.0}));
  const double no_surface = chance.one_of({0.0, 0.1, 0.5, 1.0});
  for (MeshArrays& mesh : meshes) {
    const bool is_double = chance.one_in(3), is_indexed = chance.one_in(2);
    mesh.triangles = static_cast<std::size_t>(chance.whole(0, most_triangles));
    const std::size_t count = (is_indexed ? mesh.triangles / 2 + 1 : 3 * mesh.triangles) + chance.index(3);
    Vec3d vertex = place;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || !(chance.uniform(0, 1) < no_surface)) vertex = place + chance.in_cube(1);
      if (chance.one_in(8)) vertex.set(chance.whole(0, 2), chance.one_of({0.0, -0.0}));
      for (int axis = 0; axis < 3; ++axis)
        is_double ? mesh.doubles.push_back(vertex[axis])
                  : mesh.floats.push_back(static_cast<float>(vertex[axis]));
    }
    for (std::size_t i = 0; is_indexed && i < 3 * mesh.triangles; ++i)
      mesh.indices.push_back(static_cast<std::uint32_t>(chance.index(count)));
  }
  return meshes;
}

// The same scene of all their triangles; spheres, lights and so on are `of`'s.
inline Scene written_out(const std::vector<MeshArrays>& meshes, const ArrayScene& of) {
  Scene scene{
      of.camera, of.background, of.ambient, of.has_camera, of.lights, of.materials, {}, {}, {}, {}, {}, {},
      {},        of.objects,    {}};
  for (std::size_t i = 0; i < of.spheres.size(); ++i) {
    scene.spheres.push_back(of.spheres[i]);
    scene.sphere_surfaces.push_back(of.sphere_surfaces[i]);
  }
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t i = 0; i < meshes[m].triangles; ++i)
      scene.triangles.push_back({meshes[m].corner(3 * i), m, meshes[m].corner(3 * i + 1), m,
                                 meshes[m].corner(3 * i + 2), no_normals});
  const auto has_surface = [](const SceneTriangle& t) { return t.a != t.b && t.b != t.c && t.c != t.a; };
  const auto* const first = std::find_if(scene.triangles.begin(), scene.triangles.end(), has_surface);
  const Vec3d place = first != scene.triangles.end() ? first->a : Vec3d{1, 1, 1};
  for (SceneTriangle& triangle : scene.triangles)
    if (!has_surface(triangle)) triangle.a = triangle.b = triangle.c = place;
  return scene;
}

} // namespace masu
