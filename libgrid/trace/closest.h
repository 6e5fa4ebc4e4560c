// The primitive that is closest to a place: through a hierarchy, nearest boxes first (Roussopoulos, Kelley &
// Vincent, "Nearest Neighbor Queries", SIGMOD 1995), or by trying all of them. The results are the same:
// distances are computed from primitives alone, and of those at the same one the lowest index is taken. For
// that a box is passed over only if it is farther than the closest point by more than their roundings.
#pragma once

#include "libgrid/bits.h"
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

  MASU_HD void primitive(PrimitiveIndex number) { keep(number, SceneRecord<Stored>{scene, number}); }
  // Of LeafHierarchyView.
  MASU_HD void leaf(const Leaf<Stored>* address) {
    const Leaf<Stored> leaf = fetched(address);
    keep(leaf.primitive(), leaf);
  }

  // The primitive of that number, which is admitted.
  template <class Primitive>
  MASU_HD void offer(PrimitiveIndex number, const Primitive& primitive) {
    if (!has_surface(primitive)) return;
    const ClosestPoint closest = closest_point(primitive, place);
    const double best = found.closest.squared;
    if (!(closest.squared < best || (closest.squared == best && number < found.primitive))) return;
    found = {closest, number};
    const double distance = std::sqrt(closest.squared) + slack;
    farthest = distance * distance;
  }

private:
  // `from` has the primitive's record: SceneRecord or Leaf.
  template <class From>
  MASU_HD void keep(PrimitiveIndex number, const From& from) {
    if (!filter.admits(scene, number)) return;
    if (number < scene.triangle_count)
      offer(number, widened(from.triangle()));
    else if (number - scene.triangle_count < scene.sphere_count)
      offer(number, widened(from.sphere()));
    else
      offer(number, widened(from.cone()));
  }
};

template <class Stored>
MASU_HD inline void search(const NoStructure&, ClosestSearch<Stored>& search) {
  for (PrimitiveIndex i = 0; i < search.scene.primitive_count(); ++i)
    search.primitive(i);
}

// The squared distances of `count` of a node's boxes, from a slot on.
template <int count>
MASU_HD inline void box_distances(const HierarchyNode& node, int first, const Vec3d& place,
                                  double (&squared)[count]) {
  for (double& distance : squared)
    distance = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto unit = static_cast<double>(float_of((node.exponents >> (8 * axis) & 0xff) << 23));
    const double from = place[axis] - static_cast<double>(node.origin[axis]);
    for (int i = 0; i < count; ++i) {
      const double below = unit * slot_byte(node.low[axis], first + i) - from,
                   above = from - unit * slot_byte(node.high[axis], first + i);
      const double away = fast_max(fast_max(below, above), 0.0);
      squared[i] += away * away;
    }
  }
}

// Slots of a node whose boxes are no farther than `farthest`, 4 bits each with the highest set, the nearest
// lowest.
MASU_HD inline std::uint32_t slots_in_order(const HierarchyNode& node, const Vec3d& place, double farthest) {
  double distance[boxes_per_node], sorted[boxes_per_node];
  box_distances(node, 0, place, distance);
  std::uint32_t slots = 0;
  int count = 0;
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    const double squared = distance[slot];
    if (slot_byte(node.slots, slot) == 0 || !(squared <= farthest)) continue;
    int at = count++;
    for (; at > 0 && sorted[at - 1] > squared; --at)
      sorted[at] = sorted[at - 1];
    sorted[at] = squared;
    const std::uint32_t nearer = (1U << (4 * at)) - 1;
    slots = (slots & nearer) | (slots & ~nearer) << 4 | (8U | static_cast<std::uint32_t>(slot)) << (4 * at);
  }
  return slots;
}

// Whether a node isn't one, but what is below it was shown (libgrid/placed/placed_closest.h).
template <class Hierarchy, class Search>
MASU_HD constexpr bool show_item(const Hierarchy&, std::uint32_t, Search&) {
  return false;
}

// Depth first from a node on, of each node the nearest boxes first; by whatever has `place`, `farthest`, and
// what references are shown to (hierarchy_walk.h). A level takes two numbers: a device keeps all levels for
// each of its threads.
template <class Hierarchy, class Search>
MASU_HD inline void search(const Hierarchy& hierarchy, Search& search, std::uint32_t root = 0) {
  if (show_item(hierarchy, root, search)) return;
  struct Level {
    std::uint32_t node, slots;
  };
  Level levels[max_hierarchy_depth];
  levels[0] = {root, slots_in_order(hierarchy.nodes[root], search.place, search.farthest)};
  for (int depth = 0; depth >= 0;) {
    Level& level = levels[depth];
    const HierarchyNode& node = hierarchy.nodes[level.node];
    const std::uint32_t slot = level.slots & 7;
    double squared[1] = {NAN};
    if (level.slots != 0) box_distances(node, static_cast<int>(slot), search.place, squared);
    if (!(squared[0] <= search.farthest)) {
      --depth;
      continue;
    }
    level.slots >>= 4;
    const std::uint32_t held = slot_byte(node.slots, static_cast<int>(slot)), nodes = node_slots(node);
    if ((nodes >> slot & 1) == 0) {
      const std::uint32_t begin = node.first_reference + references_begin(held);
      for (std::uint32_t i = begin; i < begin + references_in(held); ++i)
        show(hierarchy, i, search);
    } else if (depth + 1 < max_hierarchy_depth) { // always, but while a mapped file changes
      const std::uint32_t child = node_in(node.first_node, nodes, slot);
      if (show_item(hierarchy, child, search)) continue;
      levels[++depth] = {child, slots_in_order(hierarchy.nodes[child], search.place, search.farthest)};
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
