// Generalised winding numbers (Jacobson, Kavan & Sorkine-Hornung, "Robust Inside-Outside Segmentation using
// Generalized Winding Numbers", SIGGRAPH 2013): the solid angles under which a place sees triangles, positive
// from behind, summed over 4 pi. Inside of a closed mesh whose fronts are outside that is 1, outside 0; where
// it is open, turned or overlaps itself, something near.
//
// What is far away is summed as a cluster, after Barill, Dickson, Schmidt, Levin & Jacobson, "Fast Winding
// Numbers for Soups and Clouds", SIGGRAPH 2018: a Taylor series about its centroid, to the first order. Of
// the rest there is a bound, and the cluster with the largest one is divided until the sum of bounds is small
// enough. The number that is summed is G(x) = (x - q) / |x - q|³ along the normals, over 4 pi. G is the
// gradient of a harmonic function, -1 / |x - q|, whose third derivatives along unit vectors are at most
// 6 / |x - q|⁴ (Legendre). So the rest is at most 3 / (4 pi) times the integral of |x - p|² over (d - R)⁴,
// for a cluster within R of its centroid p, at the distance d.
#pragma once

#include "libgrid/trace/trace.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace masu {

inline constexpr double full_solid_angle = 4 * std::numbers::pi;

// Van Oosterom & Strackee, "The Solid Angle of a Plane Triangle", IEEE Transactions on Biomedical Engineering
// 30(2), 1983: half of it is the angle.
template <class Stored>
double winding_of(const Triangle<Stored>& triangle, const Vec3d& place) {
  const Vec3d a = cast<double>(triangle.a) - place, b = cast<double>(triangle.b) - place,
              c = cast<double>(triangle.c) - place;
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 / full_solid_angle *
         std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

// Triangles, each in one of a hierarchy's nodes or the nodes below it.
struct WindingCluster {
  Vec3d centroid{0, 0, 0};
  Vec3d area{0, 0, 0};            // the sum of normals as long as areas
  Vec3d moment[3]{};              // row i: the integral of (x - centroid)[i] times the normal
  double surface = 0, second = 0; // the area, and the integral of |x - centroid|²
  double radius = 0;              // all triangles are within it
  double triangles = 0;
};

struct WindingClusters {
  std::vector<WindingCluster> of_nodes;
  std::vector<std::uint32_t> owners; // of each triangle the reference by which it counts, of those to it
};

template <class Stored>
WindingCluster winding_cluster(const Triangle<Stored>& triangle) {
  const Triangle<double> t = widened(triangle);
  WindingCluster one;
  one.centroid = t.a * (1.0 / 3) + t.b * (1.0 / 3) + t.c * (1.0 / 3);
  one.area = cross(t.b - t.a, t.c - t.a) * 0.5;
  one.surface = length(one.area);
  double squares = 0;
  for (const Vec3d& corner : {t.a, t.b, t.c}) {
    const Vec3d away = corner - one.centroid;
    squares += dot(away, away);
    one.radius = max(one.radius, length(away));
  }
  one.second = one.surface * squares / 12;
  one.triangles = 1;
  return one;
}

// A part's, about the centroid of the whole.
inline void add(WindingCluster& whole, const WindingCluster& part) {
  const Vec3d away = part.centroid - whole.centroid;
  whole.area = whole.area + part.area;
  for (int i = 0; i < 3; ++i)
    whole.moment[i] = whole.moment[i] + part.moment[i] + part.area * away[i];
  whole.second += part.second + part.surface * dot(away, away);
  whole.radius = max(whole.radius, length(away) + part.radius);
  whole.triangles += part.triangles;
}

// Calls of_node(number) for the nodes in a node, and of_triangle(number) for the triangles that count by its
// references.
template <class Real, class OfNode, class OfTriangle>
void for_each_in_node(const HierarchyView<Real>& hierarchy, std::uint32_t number,
                      const std::vector<std::uint32_t>& owners, const OfNode& of_node,
                      const OfTriangle& of_triangle) {
  const HierarchyNode& node = hierarchy.nodes[number];
  std::uint32_t child = node.first_node;
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    if ((node_slots(node) >> slot & 1) != 0) {
      of_node(child++);
      continue;
    }
    const std::uint32_t held = slot_byte(node.slots, slot),
                        first = node.first_reference + references_begin(held);
    for (std::uint32_t i = first; i < first + references_in(held); ++i)
      if (owners[hierarchy.references[i]] == i) of_triangle(hierarchy.references[i]);
  }
}

// Of a hierarchy of the scene.
template <class Stored>
WindingClusters winding_clusters(const SceneView<Stored>& scene, const HierarchyView<Stored>& hierarchy,
                                 std::uint64_t nodes, std::uint64_t references) {
  WindingClusters clusters{std::vector<WindingCluster>(nodes),
                           std::vector<std::uint32_t>(scene.primitive_count(), 0xffffffffU)};
  for (std::uint64_t i = references; i-- > 0;)
    clusters.owners[hierarchy.references[i]] = static_cast<std::uint32_t>(i);
  std::vector<WindingCluster> parts;
  for (std::uint64_t i = nodes; i-- > 0;) { // children come after their parents
    parts.clear();
    for_each_in_node(
        hierarchy, static_cast<std::uint32_t>(i), clusters.owners,
        [&](std::uint32_t node) { parts.push_back(clusters.of_nodes[node]); },
        [&](PrimitiveIndex number) { parts.push_back(winding_cluster(scene.triangles[number])); });
    WindingCluster& whole = clusters.of_nodes[i];
    for (const WindingCluster& part : parts)
      whole.surface += part.surface;
    for (const WindingCluster& part : parts)
      if (whole.surface > 0) whole.centroid = whole.centroid + part.centroid * (part.surface / whole.surface);
    for (const WindingCluster& part : parts)
      add(whole, part);
  }
  return clusters;
}

// What of a sum isn't known better than within a bound.
struct UndividedCluster {
  std::uint64_t bound; // in units of 2^-32, whose sums are exact
  double value;
  std::uint32_t node;

  bool operator<(const UndividedCluster& other) const {
    return bound < other.bound || (bound == other.bound && node > other.node);
  }
};

// Of a cluster, seen from a place.
inline UndividedCluster undivided(const WindingCluster& cluster, std::uint32_t node, const Vec3d& place) {
  const Vec3d away = cluster.centroid - place;
  const double d = length(away), off = d - cluster.radius, most = cluster.triangles / 2;
  const double square = off * off, rest = 3 / full_solid_angle * cluster.second / (square * square);
  const auto rounded_up = [](double bound) { return static_cast<std::uint64_t>(std::ceil(bound * 0x1p32)); };
  if (!(off > 0 && rest < most)) return {rounded_up(most), 0, node};
  const Vec3d along = away * (1 / d);
  const Vec3d(&m)[3] = cluster.moment;
  const double trace = m[0].x + m[1].y + m[2].z;
  const double bent = dot(along, Vec3d{dot(m[0], along), dot(m[1], along), dot(m[2], along)});
  return {rounded_up(rest), (dot(cluster.area, along) + (trace - 3 * bent) / d) / (full_solid_angle * d * d),
          node};
}

// The winding number about a place, but for roundings off by at most `bound`; or, for `side`, by so much that
// 1/2 isn't nearer. Without nodes all triangles are summed. `room`: for what is undivided.
template <class Stored>
double winding_number(const SceneView<Stored>& scene, const HierarchyView<Stored>& hierarchy,
                      const WindingClusters& clusters, const Vec3d& place, double bound, bool side,
                      std::vector<UndividedCluster>& room) {
  if (hierarchy.nodes == nullptr) {
    double sum = 0;
    for (std::uint32_t i = 0; i < scene.triangle_count; ++i)
      sum += winding_of(scene.triangles[i], place);
    return sum;
  }
  const UndividedCluster root = undivided(clusters.of_nodes[0], 0, place);
  room.assign(1, root);
  double value = root.value;
  std::uint64_t all = root.bound;
  const auto enough = [&] {
    const double off = static_cast<double>(all) * 0x1p-32;
    return off <= bound || (side && std::abs(value - 0.5) > off);
  };
  while (!enough() && !room.empty()) {
    std::pop_heap(room.begin(), room.end());
    const UndividedCluster divided = room.back();
    room.pop_back();
    value -= divided.value;
    all -= divided.bound;
    for_each_in_node(
        hierarchy, divided.node, clusters.owners,
        [&](std::uint32_t node) {
          const UndividedCluster part = undivided(clusters.of_nodes[node], node, place);
          value += part.value;
          all += part.bound;
          room.push_back(part);
          std::push_heap(room.begin(), room.end());
        },
        [&](PrimitiveIndex number) { value += winding_of(scene.triangles[number], place); });
  }
  return value;
}

} // namespace masu
