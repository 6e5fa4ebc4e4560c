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

// Which boxes of a node are closest to a place: what is visited next. Distances are squared and in double,
// with a few roundings of the largest coordinate.
#ifdef MASU_HOST_AVX2

// Slots of a node by the squared distances of their boxes. Of those not taken yet, keys_ has the highest
// bits, without the sign; else all bits are set.
class SlotsByDistance {
  alignas(32) double squared_[boxes_per_node];
  __m128i keys_;
  static constexpr int dropped = 47;

  static __m256i key(const Lanes<double>& squared) { return _mm256_srli_epi64(squared.whole(), dropped); }

public:
  SlotsByDistance() = default;
  SlotsByDistance(const HierarchyNode& node, const Vec3d& place, double) {
    Lanes<double> sums[] = {0.0, 0.0}; // of the first four slots, of the others
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes<double> unit = static_cast<double>(float_of((node.exponents >> (8 * axis) & 0xff) << 23)),
                          from = place[axis] - static_cast<double>(node.origin[axis]);
      const Floats8 low(_mm256_cvtepi32_ps(eight_bytes(node.low[axis]))),
          high(_mm256_cvtepi32_ps(eight_bytes(node.high[axis])));
      for (const std::size_t half : {0, 1}) {
        const Lanes<double> below = unit * part_of<double>(low, 4 * half) - from,
                            above = from - unit * part_of<double>(high, 4 * half);
        const Lanes<double> away = max(max(below, above), Lanes<double>(0.0));
        sums[half] = fma(away, away, sums[half]);
      }
    }
    sums[0].store(squared_);
    sums[1].store(squared_ + 4);
    const __m256i both = _mm256_or_si256(key(sums[0]), _mm256_slli_epi64(key(sums[1]), 32)); // in turn
    const __m128i in_turn = _mm_packus_epi32(_mm256_castsi256_si128(both), _mm256_extracti128_si256(both, 1));
    keys_ = _mm_shuffle_epi8(in_turn, _mm_setr_epi8(0, 1, 4, 5, 8, 9, 12, 13, 2, 3, 6, 7, 10, 11, 14, 15));
    const __m128i held = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(node.slots));
    keys_ |= _mm_cvtepi8_epi16(_mm_cmpeq_epi8(held, _mm_setzero_si128()));
  }
  // Which is likely to be taken next; any where there is none.
  std::uint32_t likely() const {
    return static_cast<std::uint32_t>(_mm_extract_epi16(_mm_minpos_epu16(keys_), 1));
  }
  // Takes the next one that isn't farther.
  bool next(const HierarchyNode&, const Vec3d&, double farthest, std::uint32_t& slot) {
    for (;;) {
      const auto nearest = static_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_minpos_epu16(keys_)));
      slot = nearest >> 16;
      if ((nearest & 0xffff) > std::bit_cast<std::uint64_t>(farthest) >> dropped) return false;
      keys_ |=
          _mm_cmpeq_epi16(_mm_set1_epi16(static_cast<short>(slot)), _mm_setr_epi16(0, 1, 2, 3, 4, 5, 6, 7));
      if (squared_[slot] <= farthest) return true;
    }
  }
};

#else

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
class SlotsByDistance {
  std::uint32_t slots_;

public:
  SlotsByDistance() = default;
  MASU_HD SlotsByDistance(const HierarchyNode& node, const Vec3d& place, double farthest) : slots_(0) {
    double distance[boxes_per_node], sorted[boxes_per_node];
    box_distances(node, 0, place, distance);
    int count = 0;
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const double squared = distance[slot];
      if (slot_byte(node.slots, slot) == 0 || !(squared <= farthest)) continue;
      int at = count++;
      for (; at > 0 && sorted[at - 1] > squared; --at)
        sorted[at] = sorted[at - 1];
      sorted[at] = squared;
      const std::uint32_t nearer = (1U << (4 * at)) - 1;
      slots_ =
          (slots_ & nearer) | (slots_ & ~nearer) << 4 | (8U | static_cast<std::uint32_t>(slot)) << (4 * at);
    }
  }
  // The next one, if it isn't farther.
  MASU_HD bool next(const HierarchyNode& node, const Vec3d& place, double farthest, std::uint32_t& slot) {
    slot = slots_ & 7;
    double squared[1] = {NAN};
    if (slots_ != 0) box_distances(node, static_cast<int>(slot), place, squared);
    slots_ >>= 4;
    return squared[0] <= farthest;
  }
};

#endif

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
