// The primitive that is closest to a place: through a hierarchy, nearest boxes first (Roussopoulos, Kelley &
// Vincent, "Nearest Neighbor Queries", SIGMOD 1995), or by trying all of them. The results are the same:
// distances are computed from primitives alone, and of those at the same one the lowest index is taken. For
// that a box is passed over only if it is farther than the closest point by more than their roundings.
#pragma once

#include "libgrid/bits.h"
#include "libgrid/hierarchy/walk/slots_by_distance.h"
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
#ifndef __CUDA_ARCH__ // where it costs more than it saves
    if (is_farther(primitive)) return;
#endif
    const ClosestPoint closest = closest_point(primitive, place);
    const double best = found.closest.squared;
    if (!(closest.squared < best || (closest.squared == best && number < found.primitive))) return;
    found = {closest, number};
    const double distance = std::sqrt(closest.squared) + slack;
    farthest = distance * distance;
  }

private:
  // Whether a triangle's bounding box is, which takes less than to find its closest point.
  template <class Primitive>
  bool is_farther(const Primitive& primitive) const {
    if constexpr (std::is_same_v<Primitive, Triangle<double>>) {
      const Vec3d a = primitive.a - place, b = primitive.b - place, c = primitive.c - place;
      const auto away = [](double x, double y, double z) {
        return fast_max(fast_max(fast_min(fast_min(x, y), z), -fast_max(fast_max(x, y), z)), 0.0);
      };
      const Vec3d off{away(a.x, b.x, c.x), away(a.y, b.y, c.y), away(a.z, b.z, c.z)};
      return dot(off, off) > farthest;
    }
    return false;
  }

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

// Whether a node isn't one, but what is below it was shown (libgrid/placed/placed_closest.h).
template <class Hierarchy, class Search>
MASU_HD constexpr bool show_item(const Hierarchy&, std::uint32_t, Search&) {
  return false;
}

// Begins to fetch what is likely to be visited next: on the host nodes and triangles lie anywhere.
template <class Hierarchy, class Search>
MASU_HD constexpr void prefetch_likely(const Hierarchy&, const HierarchyNode&, const SlotsByDistance&,
                                       const Search&) {}
#ifdef MASU_HOST_AVX2
template <class Real, class Stored>
inline void prefetch_likely(const HierarchyView<Real>& hierarchy, const HierarchyNode& node,
                            const SlotsByDistance& slots, const ClosestSearch<Stored>& search) {
  const std::uint32_t slot = slots.likely(), held = slot_byte(node.slots, static_cast<int>(slot)),
                      nodes = node_slots(node);
  if ((nodes >> slot & 1) != 0) return prefetch(hierarchy.nodes + node_in(node.first_node, nodes, slot));
  const PrimitiveIndex* const first = hierarchy.references + node.first_reference + references_begin(held);
  for (std::uint32_t i = 0; i < references_in(held); ++i)
    if (first[i] < search.scene.triangle_count) prefetch(search.scene.triangles + first[i]);
}
#endif

// Depth first from a node on, of each node the nearest boxes first; by whatever has `place`, `farthest`, and
// what references are shown to (hierarchy_walk.h). A device keeps all levels for each of its threads: there
// one takes two numbers.
template <class Hierarchy, class Search>
MASU_HD inline void search(const Hierarchy& hierarchy, Search& search, std::uint32_t root = 0) {
  if (show_item(hierarchy, root, search)) return;
  struct Level {
    std::uint32_t node;
    SlotsByDistance slots;
  };
  Level levels[max_hierarchy_depth];
  levels[0] = {root, SlotsByDistance(hierarchy.nodes[root], search.place, search.farthest)};
  for (int depth = 0; depth >= 0;) {
    Level& level = levels[depth];
    const HierarchyNode& node = hierarchy.nodes[level.node];
    std::uint32_t slot = 0;
    if (!level.slots.next(node, search.place, search.farthest, slot)) {
      --depth;
      continue;
    }
    prefetch_likely(hierarchy, node, level.slots, search);
    const std::uint32_t held = slot_byte(node.slots, static_cast<int>(slot)), nodes = node_slots(node);
    if ((nodes >> slot & 1) == 0) {
      const std::uint32_t begin = node.first_reference + references_begin(held);
      for (std::uint32_t i = begin; i < begin + references_in(held); ++i)
        show(hierarchy, i, search);
    } else if (depth + 1 < max_hierarchy_depth) { // always, but while a mapped file changes
      const std::uint32_t child = node_in(node.first_node, nodes, slot);
      if (show_item(hierarchy, child, search)) continue;
      levels[++depth] = {child, SlotsByDistance(hierarchy.nodes[child], search.place, search.farthest)};
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
