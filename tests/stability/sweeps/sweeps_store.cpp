// Scenes of small parts, stored as `--store auto` does (libscene/float32_precision.h): the judge's scene is
// the one before its coordinates are rounded.
#include "stability/sweeps/mesh_rays.h"

#include <algorithm>

namespace masu::stability {
namespace {

Vec3d middle_of(const Mesh<double>& mesh, const std::array<std::size_t, 3>& face) {
  return (mesh.corners[face[0]] + mesh.corners[face[1]] + mesh.corners[face[2]]) * (1.0 / 3);
}

// --- Parts that stand alone -----------------------------------------------------------------------------

// Triangles and spheres of the parameter's size around a ball. Rays aim at them.
template <class Stored>
Trial<Stored> specks(Chance& chance, double parameter, std::size_t rays) {
  TestScene<double> scene;
  std::vector<Vec3d> places;
  for (int i = 0; i < 24; ++i) {
    const Vec3d at = chance.direction() * chance.uniform(1.3, 1.6), side = across(chance, at);
    const Vec3d other = normalized(cross(at, side));
    const double half = parameter / 2;
    if (chance.one_in(3) && half > 0)
      scene.add(Sphere<double>{at, half});
    else
      scene.add(triangle_of(at + side * half, at - side * half + other * (half / 2),
                            at - side * (half / 2) - other * half));
    places.push_back(at);
  }
  add_mesh(scene, octahedron(chance, 2, 0.1));
  Trial<Stored> trial{converted<Stored>(scene), {}};
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d& at = places[chance.index(places.size())];
    const Vec3d target = at + chance.in_cube(parameter * chance.one_of({0.1, 0.2, 1.0}));
    trial.rays.push_back(ray_towards<Stored>(at * chance.uniform(1.05, 1.3) + chance.in_cube(0.1), target));
  }
  trial.original = std::move(scene);
  return trial;
}

// --- Parts of a surface ---------------------------------------------------------------------------------

// Inserts a triangle of that size in a face, divided into more, so that some touch small ones alone.
void insert_speck(Chance& chance, Mesh<double>& mesh, std::size_t face, double size) {
  const auto [a, b, c] = mesh.faces[face];
  const Vec3d middle = middle_of(mesh, mesh.faces[face]);
  const auto corner_towards = [&](std::size_t corner) {
    const Vec3d along = mesh.corners[corner] - middle;
    mesh.corners.push_back(middle + along * (size / largest_magnitude(along)) + chance.in_cube(size / 4));
    return mesh.corners.size() - 1;
  };
  const std::size_t p = corner_towards(a), q = corner_towards(b), r = corner_towards(c);
  mesh.faces[face] = {p, q, r};
  for (const auto& more : {std::array{a, b, p}, {b, q, p}, {b, c, q}, {c, r, q}, {c, a, r}, {a, p, r}})
    mesh.faces.push_back(more);
  for (int times = 0; times < 2; ++times) {
    const auto [u, v, w] = mesh.faces[face];
    mesh.corners.push_back(middle_of(mesh, mesh.faces[face]) + chance.in_cube(size / 8));
    const std::size_t inside = mesh.corners.size() - 1;
    mesh.faces[face] = {u, v, inside};
    mesh.faces.push_back({v, w, inside});
    mesh.faces.push_back({w, u, inside});
  }
}

// Splits an edge at that distance from one end, and the two faces at it: two slivers.
void insert_sliver(Chance& chance, Mesh<double>& mesh, std::size_t face, double width) {
  const std::size_t from = mesh.faces[face][0], to = mesh.faces[face][1];
  const Vec3d along = normalized(mesh.corners[to] - mesh.corners[from]);
  mesh.corners.push_back(mesh.corners[from] + along * width + chance.in_cube(width / 8));
  const std::size_t point = mesh.corners.size() - 1, faces = mesh.faces.size();
  for (std::size_t i = 0; i < faces; ++i) {
    auto sliver = mesh.faces[i];
    const auto at_to = std::find(sliver.begin(), sliver.end(), to);
    if (at_to == sliver.end() || std::find(sliver.begin(), sliver.end(), from) == sliver.end()) continue;
    auto rest = sliver;
    *at_to = point;
    *std::find(rest.begin(), rest.end(), from) = point;
    mesh.faces[i] = rest;
    mesh.faces.push_back(sliver);
  }
}

bool has_corners_at_one_point(const Mesh<double>& mesh, const std::array<std::size_t, 3>& face) {
  const auto& [a, b, c] = face;
  return mesh.corners[a] == mesh.corners[b] || mesh.corners[b] == mesh.corners[c] ||
         mesh.corners[c] == mesh.corners[a];
}

// A closed mesh with specks and slivers of that size in its surface.
Mesh<double> rough_ball(Chance& chance, double size) {
  Mesh<double> mesh = octahedron(chance, 2, 0.1);
  const std::size_t faces = mesh.faces.size();
  for (int i = 0; i < 24; ++i) {
    const std::size_t face = chance.index(faces);
    if (has_corners_at_one_point(mesh, mesh.faces[face])) continue; // by an earlier one of size 0
    chance.one_in(2) ? insert_speck(chance, mesh, face, size) : insert_sliver(chance, mesh, face, size);
  }
  return mesh;
}

// The ball as it is stored, without rays.
template <class Stored>
Trial<Stored> trial_of(const Mesh<double>& mesh) {
  TestScene<double> scene;
  add_mesh(scene, mesh);
  Trial<Stored> trial{converted<Stored>(scene), {}};
  trial.original = std::move(scene);
  return trial;
}

// From outside: one ray in four aims at any face, the others at the ball.
template <class Stored>
Trial<Stored> rough_surface(Chance& chance, double parameter, std::size_t rays) {
  const Mesh<double> mesh = rough_ball(chance, parameter);
  Trial<Stored> trial = trial_of<Stored>(mesh);
  for (std::size_t i = 0; i < rays; ++i) {
    const Vec3d target = chance.one_in(4) ? middle_of(mesh, mesh.faces[chance.index(mesh.faces.size())])
                                          : chance.direction() * chance.uniform(0, 1);
    trial.rays.push_back(ray_towards<Stored>(chance.direction() * 3.0, target));
  }
  return trial;
}

// From inside, at corners and edges.
template <class Stored>
Trial<Stored> inside_rough_surface(Chance& chance, double parameter, std::size_t rays) {
  const Mesh<double> mesh = rough_ball(chance, parameter);
  Trial<Stored> trial = trial_of<Stored>(mesh);
  trial.rays = edge_rays<Stored>(chance, mesh, {0, 0, 0}, 1, rays);
  return trial;
}

} // namespace

std::vector<Sweep> store_sweeps() {
  const std::vector<double> to_zero = zero_and_powers_of_ten(-9, -2);
  return {
      {.name = "specks",
       .parameter = "size of triangles and spheres that stand alone, scene of size 3",
       .float32_steps = powers_of_ten(-4, -1),
       .float64_steps = powers_of_ten(-12, -5),
       .float32 = specks<float>,
       .float64 = specks<double>,
       .robust = {1e-3, 1},
       .doubled64 = {1e-11, 1},
       .by_rule = true},
      {.name = "rough",
       .parameter = "size of triangles and width of slivers in a closed mesh",
       .float32_steps = to_zero,
       .float32 = rough_surface<float>,
       .by_rule = true},
      {.name = "closed-rough",
       .parameter = "size of triangles and width of slivers; rays at edges and corners from inside",
       .judge = Judge::enclosed,
       .share = 4,
       .float32_steps = to_zero,
       .float32 = inside_rough_surface<float>,
       .by_rule = true},
  };
}

} // namespace masu::stability
