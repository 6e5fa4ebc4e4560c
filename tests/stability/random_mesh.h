// Closed meshes around the origin, of size 1.
#pragma once

#include "stability/test_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace masu {

template <class Real>
struct Mesh {
  std::vector<Vec3<Real>> corners;
  std::vector<std::array<std::size_t, 3>> faces;
};

// An octahedron, each face subdivided into four `rounds` times, its corners moved in and out at random.
inline Mesh<double> octahedron(Chance& chance, int rounds, double jitter) {
  Mesh<double> mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (std::size_t x : {0U, 1U})
    for (std::size_t y : {2U, 3U})
      for (std::size_t z : {4U, 5U})
        mesh.faces.push_back({x, y, z});
  for (; rounds > 0; --rounds) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), mesh.corners.size());
      if (is_new) mesh.corners.push_back(normalized(mesh.corners[a] + mesh.corners[b]));
      return found->second;
    };
    std::vector<std::array<std::size_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.faces) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& face : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(face);
    }
    mesh.faces = finer;
  }
  for (Vec3d& corner : mesh.corners)
    corner = corner * chance.uniform(1 - jitter, 1 + jitter);
  return mesh;
}

inline Mesh<double> tetrahedron(Chance& chance) {
  Mesh<double> mesh{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                    {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  for (Vec3d& corner : mesh.corners)
    corner = corner + chance.in_cube(0.1);
  return mesh;
}

inline Mesh<double> cube() {
  Mesh<double> mesh;
  for (unsigned i = 0; i < 8; ++i)
    mesh.corners.push_back({(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0});
  for (std::size_t bit : {1U, 2U, 4U}) {
    const std::size_t u = bit == 4 ? 1 : bit * 2, v = 7 ^ bit ^ u;
    for (std::size_t side : {std::size_t{0}, bit}) {
      mesh.faces.push_back({side, side | u, side | u | v});
      mesh.faces.push_back({side, side | v, side | u | v});
    }
  }
  return mesh;
}

// Two tips and many thin triangles from each.
inline Mesh<double> double_fan(Chance& chance, std::size_t blades) {
  Mesh<double> mesh{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::size_t i = 0; i < blades; ++i) {
    const double angle = 2 * 3.14159265358979 * (static_cast<double>(i) + chance.uniform(0, 0.99)) /
                         static_cast<double>(blades);
    mesh.corners.push_back({std::cos(angle), std::sin(angle), chance.uniform(-0.05, 0.05)});
    const std::size_t next = (i + 1) % blades;
    for (std::size_t tip : {0U, 1U})
      mesh.faces.push_back({tip, i + 2, next + 2});
  }
  return mesh;
}

inline Mesh<double> random_mesh(Chance& chance) {
  switch (chance.whole(0, 5)) {
  case 0:
    return tetrahedron(chance);
  case 1:
    return cube();
  case 2:
    return double_fan(chance, static_cast<std::size_t>(chance.whole(8, 100)));
  case 3:
    return octahedron(chance, chance.whole(0, 2), 0);
  default:
    return octahedron(chance, chance.whole(1, 2), 0.2);
  }
}

} // namespace masu
