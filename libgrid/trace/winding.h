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

#include <vector>

namespace masu {

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

// Of a hierarchy of the scene.
template <class Stored>
WindingClusters winding_clusters(const SceneView<Stored>& scene, const HierarchyView<Stored>& hierarchy,
                                 std::uint64_t nodes, std::uint64_t references);

// What of a sum isn't known better than within a bound.
struct UndividedCluster {
  std::uint64_t bound; // in units of 2^-32, whose sums are exact
  double value;
  std::uint32_t node;

  bool operator<(const UndividedCluster& other) const {
    return bound < other.bound || (bound == other.bound && node > other.node);
  }
};

// The winding number about a place, but for roundings off by at most `bound`; or, for `side`, by so much that
// 1/2 isn't nearer. Without nodes all triangles are summed. `room`: for what is undivided.
template <class Stored>
double winding_number(const SceneView<Stored>& scene, const HierarchyView<Stored>& hierarchy,
                      const WindingClusters& clusters, const Vec3d& place, double bound, bool side,
                      std::vector<UndividedCluster>& room);
// By all triangles.
template <class Stored>
double winding_number(const SceneView<Stored>& scene, const Vec3d& place) {
  std::vector<UndividedCluster> none;
  return winding_number(scene, HierarchyView<Stored>{}, {}, place, 0, false, none);
}

} // namespace masu
