// The primitive that is closest to a place: through a hierarchy, nearest boxes first (Roussopoulos, Kelley &
// Vincent, "Nearest Neighbor Queries", SIGMOD 1995), or by trying all of them. The results are the same:
// distances are computed from primitives alone, and of those at the same one the lowest index is taken. For
// that a box is passed over only if it is farther than the closest point by more than their roundings.
#pragma once

#include "libgrid/trace/hits_in_order.h"
#include "libscene/geometry/closest_point.h"

namespace masu {

inline constexpr double max_closest = 1e37; // coordinates, of scenes too

struct ClosestPrimitive {
  ClosestPoint closest;
  PrimitiveIndex primitive = no_primitive;
};

// Keeps the closest of the primitives that it is shown.
template <class Stored>
struct ClosestSearch {
  const SceneView<Stored>& scene;
  Vec3d place;
  const HitFilter& filter; // of any side
  double slack;            // of distances, for roundings
  ClosestPrimitive found{};
  double farthest = INFINITY; // squared, of boxes that may hold something closer, or as close

  MASU_HD ClosestSearch(const SceneView<Stored>& scene_, const Vec3d& place_, const HitFilter& filter_)
      : scene(scene_), place(place_), filter(filter_),
        slack(0x1p-44 * (largest_magnitude(place_) + static_cast<double>(largest_magnitude(scene_.clip)))) {}

  MASU_HD void primitive(PrimitiveIndex number) {
    if (!filter.admits(scene, number)) return;
    with_primitive(scene, number, [&](const auto& primitive) {
      if (!has_surface(primitive)) return;
      const ClosestPoint closest = closest_point(primitive, place);
      const double best = found.closest.squared;
      if (!(closest.squared < best || (closest.squared == best && number < found.primitive))) return;
      found = {closest, number};
      const double distance = std::sqrt(closest.squared) + slack;
      farthest = distance * distance;
    });
  }
};

template <class Stored>
MASU_HD inline void search(const NoStructure&, ClosestSearch<Stored>& search) {
  for (PrimitiveIndex i = 0; i < search.scene.primitive_count(); ++i)
    search.primitive(i);
}

// The squared distances of a node's boxes.
MASU_HD inline void box_distances(const HierarchyNode& node, const Vec3d& place,
                                  double (&squared)[boxes_per_node]) {
  for (double& distance : squared)
    distance = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto unit = static_cast<double>(float_of((node.exponents >> (8 * axis) & 0xff) << 23));
    const double from = place[axis] - static_cast<double>(node.origin[axis]);
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const double below = unit * slot_byte(node.low[axis], slot) - from,
                   above = from - unit * slot_byte(node.high[axis], slot);
      const double away = fast_max(fast_max(below, above), 0.0);
      squared[slot] += away * away;
    }
  }
}

template <class Real, class Stored>
MASU_HD inline void search(const HierarchyView<Real>& hierarchy, ClosestSearch<Stored>& search) {
  struct Waiting {
    double squared;
    std::uint32_t node;
  };
  constexpr int room = max_hierarchy_depth * (boxes_per_node - 1) + 1;
  Waiting stack[room];
  int waiting = 0;
  stack[waiting++] = {0, 0};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared > search.farthest) continue;
    const HierarchyNode& node = hierarchy.nodes[next.node];
    double squared[boxes_per_node];
    box_distances(node, search.place, squared);
    // There is room, but while a mapped file changes: then results are thrown away.
    if (waiting > room - boxes_per_node) waiting = 0;
    const int first = waiting;
    std::uint32_t child = node.first_node;
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t held = slot_byte(node.slots, slot);
      if ((node_slots(node) >> slot & 1) != 0) {
        // Nearest last, from where it is taken.
        int at = waiting++;
        for (; at > first && stack[at - 1].squared < squared[slot]; --at)
          stack[at] = stack[at - 1];
        stack[at] = {squared[slot], child++};
      } else if (squared[slot] <= search.farthest) {
        const std::uint32_t begin = node.first_reference + references_begin(held);
        for (std::uint32_t i = begin; i < begin + references_in(held); ++i)
          search.primitive(hierarchy.references[i]);
      }
    }
  }
}

// No primitive where there is none, or a coordinate of the place is NaN, infinite or beyond max_closest.
template <class Stored, class Hierarchy>
MASU_HD inline ClosestPrimitive closest_primitive(const SceneView<Stored>& scene, const Hierarchy& hierarchy,
                                                  const Vec3d& place, const HitFilter& filter) {
  ClosestSearch<Stored> closest(scene, place, filter);
  if (largest_magnitude(place) <= max_closest && (place.x + place.y + place.z) * 0 == 0)
    search(hierarchy, closest);
  return closest.found;
}

} // namespace masu
