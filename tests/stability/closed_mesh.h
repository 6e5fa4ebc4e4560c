// Closed meshes whose triangles show their front outside, and rays that cross them where it is hard to say
// how often: through corners, along edges, in the planes of faces.
#pragma once

#include "stability/random_mesh.h"

#include <span>
#include <tuple>

namespace masu {

// random_mesh() with its faces turned outwards, slivers at corners and edges, edges that are split in one of
// their faces alone, with a face without area that fills the gap, and maybe pockets: two triangles back to
// back.
template <class Stored>
std::vector<Triangle<Stored>> closed_mesh(Chance& chance, double size, bool has_pockets) {
  Mesh<double> mesh = random_mesh(chance);
  for (auto& [a, b, c] : mesh.faces) {
    const Vec3d &p = mesh.corners[a], &q = mesh.corners[b], &r = mesh.corners[c];
    if (dot(cross(q - p, r - p), p + q + r) < 0) std::swap(b, c);
  }
  const bool on_lattice = chance.one_in(3); // where rays meet corners and edges exactly
  for (Vec3d& corner : mesh.corners)
    corner =
        kept<float>(on_lattice && chance.one_in(2) ? cast<double>(cast<int>(corner * 8.0)) * 0.125 : corner);
  for (int slivers = chance.whole(0, 20); slivers > 0; --slivers) { // a corner in a face: three faces of one
    auto& face = mesh.faces[chance.index(mesh.faces.size())];
    const auto [a, b, c] = face;
    const double near = chance.one_in(2) ? chance.uniform(0, 1) : chance.power_of_two(-30, 0),
                 along = chance.one_of({0.0, near, 0.5});
    const std::size_t inner = mesh.corners.size();
    mesh.corners.push_back(kept<float>(mesh.corners[a] + (mesh.corners[b] - mesh.corners[a]) * along +
                                       (mesh.corners[c] - mesh.corners[a]) * (near * (1 - along))));
    face = {a, b, inner};
    mesh.faces.push_back({b, c, inner});
    mesh.faces.push_back({c, a, inner});
  }
  for (int fillers = chance.whole(0, 20); fillers > 0; --fillers) {
    auto& face = mesh.faces[chance.index(mesh.faces.size())];
    const auto [a, b, c] = face;
    const double along = chance.one_of({0.5, 0.25, chance.uniform(0, 1)});
    const Vec3d &p = mesh.corners[a], &q = mesh.corners[b], middle = kept<float>(p + (q - p) * along);
    if (middle == p || middle == q) continue;
    const std::size_t between = mesh.corners.size();
    mesh.corners.push_back(middle);
    face = {a, between, c};
    mesh.faces.push_back({between, b, c});
    mesh.faces.push_back({a, b, between});
  }
  std::vector<Triangle<Stored>> triangles;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.push_back(triangle_of(cast<Stored>(mesh.corners[a] * size),
                                    cast<Stored>(mesh.corners[b] * size),
                                    cast<Stored>(mesh.corners[c] * size)));
  };
  for (const auto& [a, b, c] : mesh.faces)
    add(a, b, c);
  for (int pockets = has_pockets ? chance.whole(0, 3) : 0; pockets > 0; --pockets) {
    const auto corner = [&] { return chance.index(mesh.corners.size()); };
    const std::size_t a = corner(), b = corner(), c = corner();
    add(a, b, c);
    add(a, c, b);
  }
  std::shuffle(triangles.begin(), triangles.end(), chance.engine());
  return triangles;
}

// Whether every edge is run through in both directions equally often.
template <class Stored>
bool is_closed(std::span<const Triangle<Stored>> triangles) {
  using Corner = std::tuple<Stored, Stored, Stored>;
  using Edge = std::tuple<Corner, Corner, int>; // from the lesser corner, 1, or to it, -1
  std::vector<Edge> edges;
  const auto corner = [](const Vec3<Stored>& v) { return Corner{v.x + 0, v.y + 0, v.z + 0}; }; // -0 is 0
  for (const Triangle<Stored>& t : triangles) {
    const Corner corners[] = {corner(t.a), corner(t.b), corner(t.c)};
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &from = corners[i], &to = corners[(i + 1) % 3];
      if (from < to) edges.emplace_back(from, to, 1);
      if (to < from) edges.emplace_back(to, from, -1);
    }
  }
  std::ranges::sort(edges);
  int sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    sum += std::get<2>(edges[i]);
    const bool is_last = i + 1 == edges.size() || std::get<0>(edges[i]) != std::get<0>(edges[i + 1]) ||
                         std::get<1>(edges[i]) != std::get<1>(edges[i + 1]);
    if (is_last && sum != 0) return false;
  }
  return true;
}

// A ray towards a mesh of so large a largest coordinate, from a few times as far. One in three is parallel to
// an axis or to the plane of two: then it meets corners and edges exactly.
template <class Real, class Stored>
Ray<Real> crossing_ray(Chance& chance, std::span<const Triangle<Stored>> triangles, double size) {
  const Triangle<double> t = widened(triangles[chance.index(triangles.size())]);
  Vec3d target = chance.one_of({t.a, t.b, t.c}), direction = chance.direction();
  switch (chance.whole(0, 7)) {
  case 0: // a point of an edge
    target = t.a + (t.b - t.a) * chance.one_of({0.25, 0.5, chance.uniform(0, 1)});
    break;
  case 1: // of the face
    target = t.a + (t.b - t.a) * chance.uniform(0, 0.5) + (t.c - t.a) * chance.uniform(0, 0.5);
    break;
  case 2:
    direction = t.b - t.a;
    break;
  case 3: // in the plane
    direction = (t.b - t.a) * chance.uniform(-1, 1) + (t.c - t.a) * chance.uniform(-1, 1);
    break;
  case 4: { // through another corner
    const Triangle<double> other = widened(triangles[chance.index(triangles.size())]);
    direction = chance.one_of({other.a, other.b, other.c}) - target;
    break;
  }
  default:
    break;
  }
  if (chance.one_in(3))
    for (int axis = chance.whole(0, 2), i = chance.whole(1, 2); i > 0; --i)
      direction.set((axis + i) % 3, 0);
  if (!(largest_magnitude(direction) > 0)) direction = {0, 0, 1};
  const Vec3<Real> along = cast<Real>(normalized(direction));
  const double away = size * chance.uniform(4, 8);
  return unbounded_ray(cast<Real>(target - cast<double>(along) * away), along);
}

// How often the surface winds round a point, which lies off it: the sum of solid angles over 4 pi. After Van
// Oosterom & Strackee, IEEE Transactions on Biomedical Engineering 30(2), 1983.
template <class Stored>
double winding_number(std::span<const Triangle<Stored>> triangles, const Vec3d& point) {
  double sum = 0;
  for (const Triangle<Stored>& triangle : triangles) {
    const Triangle<double> t = widened(triangle);
    const Vec3d a = t.a - point, b = t.b - point, c = t.c - point;
    const double la = length(a), lb = length(b), lc = length(c);
    sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (2 * 3.14159265358979323846);
}

} // namespace masu
