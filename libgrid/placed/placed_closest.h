// The triangle of placed meshes, or what stands beside them, that is closest to a place
// (libgrid/trace/closest.h).
//
// Boxes of a mesh are as far from the carried place, divided by how much the inverse lengthens a vector at
// most, as they are in the world at least; less what the padding of planes is for, and what double rounds,
// which the search's slack covers.
#pragma once

#include "libgrid/placed/placed_view.h"
#include "libgrid/trace/closest.h"

namespace masu {

// The square of how much the inverse lengthens a vector at most: by the largest sum of the magnitudes in a
// row of N N^T, which for a rotation and a scale it just is.
template <class Stored>
MASU_HD inline double squared_lengthening(const Placement<Stored>& placement) {
  const auto& n = placement.inverse;
  double most = 0;
  for (const auto& row : n) {
    double sum = 0;
    for (const auto& other : n)
      sum += std::abs(double{row[0]} * other[0] + double{row[1]} * other[1] + double{row[2]} * other[2]);
    most = max(most, sum);
  }
  return most * (1 + 0x1p-40);
}

// Of one placement's mesh, shown its leaves.
template <class Stored>
struct PlacedMeshSearch {
  ClosestSearch<Stored>& found;
  const PlacedView<Stored>& placed;
  std::uint32_t placement = 0;
  Vec3d place{}; // carried
  double lengthening = 0, padding = 0, farthest = 0;

  MASU_HD void update() {
    const double away = std::sqrt(found.farthest * lengthening) + padding;
    farthest = away * away * (1 + 0x1p-40);
  }
  MASU_HD void leaf(const Leaf<Stored>* address) {
    const Leaf<Stored> leaf = fetched(address);
    const PrimitiveIndex number = placed.first_triangles[placement] + leaf.primitive();
    if (number == found.filter.excluded) return;
    found.offer(number, widened(placed_surface(placed.placements[placement], leaf.record)));
    update();
  }
};

// Of an item of the hierarchies above them.
template <class Stored>
MASU_HD inline void search_item(const PlacedRay<Stored>& seen, std::uint32_t item,
                                ClosestSearch<Stored>& closest) {
  const PlacedView<Stored>& placed = seen.placed;
  if (item >= placed.count) return closest.primitive(placed.triangle_count() + (item - placed.count));
  const Placement<Stored>& own = placed.placements[item];
  if (!seen.sees(item, own)) return;
  const PlacedMesh<Stored>& mesh = placed.meshes[own.mesh];
  PlacedMeshSearch<Stored> in_mesh{closest,
                                   placed,
                                   item,
                                   carried_point(own, closest.place),
                                   squared_lengthening(own),
                                   2 * static_cast<double>(own.padding)}; // the diagonal is sqrt 3 of it
  in_mesh.update();
  if (!placed.is_brute_force)
    return search(LeafHierarchyView<double, Stored>{placed.of_meshes.nodes, placed.of_meshes.leaves}, in_mesh,
                  own.root);
  for (std::uint32_t i = 0; i < mesh.leaf_count; ++i)
    in_mesh.leaf(placed.of_meshes.leaves + mesh.first_leaf + i);
}

// The hierarchies above, where a node may be an item.
template <class Stored>
struct UpperHierarchy {
  const PlacedRay<Stored>& seen;
  const HierarchyNode* nodes;
};
template <class Stored>
MASU_HD inline bool show_item(const UpperHierarchy<Stored>& above, std::uint32_t node,
                              ClosestSearch<Stored>& closest) {
  if (node_slots(above.nodes[node]) != 0) return false;
  search_item(above.seen, above.nodes[node].first_reference, closest);
  return true;
}
template <class Stored>
MASU_HD inline void show(const UpperHierarchy<Stored>&, std::uint32_t, ClosestSearch<Stored>&) {}

template <class Stored>
MASU_HD inline void search(const PlacedRay<Stored>& seen, ClosestSearch<Stored>& closest) {
  const PlacedView<Stored>& placed = seen.placed;
  if (placed.is_brute_force) {
    for (std::uint32_t i = 0; i < placed.count + closest.scene.sphere_count + closest.scene.cone_count; ++i)
      if (i >= placed.count || placed.placements[i].world == seen.world ||
          placed.placements[i].world == every_world)
        search_item(seen, i, closest);
    return;
  }
  const UpperHierarchy<Stored> above{seen, placed.upper_nodes};
  const auto [first, second] = seen.roots();
  if (first != no_root) search(above, closest, first);
  if (second != no_root) search(above, closest, second);
}

} // namespace masu
