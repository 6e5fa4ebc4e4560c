// Meshes in trials, and rays at their corners and edges.
#pragma once

#include "stability/random_mesh.h"
#include "stability/sweeps/sweep.h"

namespace masu::stability {

template <class Stored>
void add_mesh(TestScene<Stored>& scene, const Mesh<double>& mesh) {
  for (const auto& [a, b, c] : mesh.faces)
    scene.add(triangle_of<Stored>(mesh.corners[a], mesh.corners[b], mesh.corners[c]));
}

// From around the mesh's centre to its corners, as they are stored, and to points on its edges.
template <class Stored>
std::vector<Ray<double>> edge_rays(Chance& chance, const Mesh<double>& mesh, const Vec3d& center, double size,
                                   std::size_t count) {
  std::vector<Ray<double>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& face = mesh.faces[chance.index(mesh.faces.size())];
    const std::size_t corner = chance.index(3);
    const Vec3d a = kept<Stored>(mesh.corners[face[corner]]),
                b = kept<Stored>(mesh.corners[face[(corner + 1) % 3]]);
    const double share = chance.one_of({0.0, 0.0, 0.5, 0.25, chance.uniform(0, 1)});
    const Vec3d from = chance.one_in(4) ? center : center + chance.in_cube(0.1 * size);
    rays.push_back(ray_towards<Stored>(from, a + (b - a) * share));
  }
  return rays;
}

} // namespace masu::stability
