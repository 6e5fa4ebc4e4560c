#include "libscene/mesh/tessellate.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace masu {
namespace {

// Corners on the unit sphere, which are also their normals; counter-clockwise seen from outside.
using UnitTriangle = std::array<Vec3d, 3>;

// Splits a square of a face along its shorter diagonal; along the first one when they are equal up to
// rounding, so that equal squares are split alike.
void append_square(std::vector<UnitTriangle>& triangles, const std::array<Vec3d, 4>& q) {
  const Vec3d first = q[2] - q[0], second = q[3] - q[1];
  if (dot(second, second) < 0.999 * dot(first, first)) {
    triangles.push_back({q[0], q[1], q[3]});
    triangles.push_back({q[1], q[2], q[3]});
  } else {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
}

std::vector<UnitTriangle> unit_sphere(int facets) {
  const int squares = facets / 4; // along a face's edge
  // Lattice points on the cube, each coordinate from -squares to squares. Faces that meet share them, and so
  // get the same bits.
  const auto direction = [&](const Vec3i& point) {
    const auto coordinate = [&](int i) { return std::tan(std::numbers::pi / 4 * i / squares); };
    return normalized(Vec3d{coordinate(point.x), coordinate(point.y), coordinate(point.z)});
  };
  std::vector<UnitTriangle> triangles;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, side = face % 2 == 0 ? 1 : -1;
    const auto corner = [&](int i, int j) {
      Vec3i point{};
      point.set(axis, side * squares);
      point.set((axis + side + 3) % 3, 2 * i - squares); // the negative side swaps the other two axes
      point.set((axis - side + 3) % 3, 2 * j - squares);
      return direction(point);
    };
    for (int i = 0; i < squares; ++i)
      for (int j = 0; j < squares; ++j)
        append_square(triangles, {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  }
  return triangles;
}

// A negative radius mirrors every corner, so that the triangles face inwards, as the unchanged normals then
// do.
void append_spheres(Scene& scene, int facets) {
  if (scene.spheres.empty()) return;
  const std::vector<UnitTriangle> unit = unit_sphere(facets);
  const std::uint64_t first_normals = scene.normals.size();
  for (const auto& [a, b, c] : unit)
    scene.normals.push_back({a, b, c});
  for (std::size_t s = 0; s < scene.spheres.size(); ++s) {
    const auto [center, radius] = scene.spheres[s];
    const auto [object, material] = scene.sphere_surfaces[s];
    for (std::size_t i = 0; i < unit.size(); ++i) {
      const auto& [a, b, c] = unit[i];
      scene.triangles.push_back({fma(a, radius, center), object, fma(b, radius, center), material,
                                 fma(c, radius, center), first_normals + i});
    }
  }
}

struct Point {
  Vec3d position, normal;
};

void append(Scene& scene, const Surface& surface, const Point& a, const Point& b, const Point& c) {
  scene.triangles.push_back({a.position, surface.object, b.position, surface.material, c.position,
                             std::uint64_t{scene.normals.size()}});
  scene.normals.push_back({a.normal, b.normal, c.normal});
}

// An edge between two sides, a line on the surface.
struct Edge {
  Point base, apex;
};

// The `facets` edges, counter-clockwise about the axis, or clockwise for negative radii: these rotate every
// edge by half a turn, which by itself leaves the fronts outside.
std::vector<Edge> cone_edges(const Cone<double>& cone, int facets) {
  const Vec3d axis = cone.apex - cone.base;
  const Vec3d along = normalized(axis * 1e100); // scaled: a difference of coordinates can be denormal
  const double height = dot(axis, along), growth = cone.apex_radius - cone.base_radius;
  const double slant = std::hypot(height, growth);
  const double sense = std::copysign(1.0, cone.base_radius + cone.apex_radius);
  const Vec3d u = normalized(cross(std::abs(along.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, along));
  const Vec3d v = cross(along, u) * sense;
  std::vector<Edge> edges;
  edges.reserve(static_cast<std::size_t>(facets));
  for (int i = 0; i < facets; ++i) {
    const double angle = 2 * std::numbers::pi * i / facets;
    const Vec3d away = fma(u, std::cos(angle), v * std::sin(angle));
    const Vec3d normal = fma(along, -growth / slant, away * (height / slant));
    edges.push_back(
        {{fma(away, cone.base_radius, cone.base), normal}, {fma(away, cone.apex_radius, cone.apex), normal}});
  }
  return edges;
}

void append_cone(Scene& scene, const Cone<double>& cone, const Surface& surface, int facets) {
  const std::vector<Edge> edges = cone_edges(cone, facets);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& left = edges[i];
    const Edge& right = edges[(i + 1) % edges.size()];
    // A pointed end has no normal: take the mean of the side's.
    const Vec3d middle = left.base.normal + right.base.normal;
    if (cone.base_radius != 0)
      append(scene, surface, left.base, right.base,
             cone.apex_radius != 0 ? right.apex : Point{cone.apex, middle});
    if (cone.apex_radius != 0)
      append(scene, surface, cone.base_radius != 0 ? left.base : Point{cone.base, middle}, right.apex,
             left.apex);
  }
}

std::uint64_t triangles_of_cones(const Scene& scene, int facets) {
  std::uint64_t sides = 0; // of one triangle: one for each end that isn't pointed
  for (const Cone<double>& cone : scene.cones)
    sides += (cone.base_radius != 0 ? 1U : 0U) + (cone.apex_radius != 0 ? 1U : 0U);
  return sides * static_cast<std::uint64_t>(facets);
}

} // namespace

Scene tessellated(Scene scene, int facets) {
  const auto squares = static_cast<std::uint64_t>(facets / 4);
  const std::uint64_t a_sphere = 12 * squares * squares;
  const std::uint64_t of_cones = triangles_of_cones(scene, facets);
  const std::uint64_t all = scene.triangles.size() + scene.spheres.size() * a_sphere + of_cones;
  if (all > max_primitives)
    throw Error(
        ErrorCode::usage, "--tessellate",
        fmt::format("would make {} triangles, more than {}: choose fewer facets", all, max_primitives));
  // Growing by doubling would need twice the memory.
  scene.triangles.reserve(all);
  scene.normals.reserve(scene.normals.size() + (scene.spheres.empty() ? 0 : a_sphere) + of_cones);
  append_spheres(scene, facets);
  for (std::size_t i = 0; i < scene.cones.size(); ++i)
    append_cone(scene, scene.cones[i], scene.cone_surfaces[i], facets);
  scene.spheres = {};
  scene.sphere_surfaces = {};
  scene.cones = {};
  scene.cone_surfaces = {};
  return scene;
}

} // namespace masu
