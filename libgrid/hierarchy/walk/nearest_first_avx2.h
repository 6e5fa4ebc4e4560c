// The walk of one ray on one lane of a processor with AVX2: eight boxes at a time, the nodes met from the
// nearest on, and up to eight triangles at a time. Host only.
#pragma once

#include "libgrid/hierarchy/walk/boxes_avx2.h"
#include "libscene/geometry/triangle_lanes.h"
#include "libscene/scene_view.h"

#include <algorithm>
#include <bit>

namespace masu {

// A node that is still to be visited: the bits of where the ray enters it, then its index: so that the
// smaller number is nearer.
using NodeAhead = std::uint64_t;
inline NodeAhead node_ahead(float enter, std::uint32_t index) {
  return static_cast<NodeAhead>(bits_of(enter)) << 32 | index;
}
inline constexpr NodeAhead nothing_ahead = ~NodeAhead{0}; // entered at NaN
inline float enters_at(NodeAhead node) {
  return float_of(static_cast<std::uint32_t>(node >> 32));
}

// Calls found(primitive, t) for each of references[i], bit i of `bits` set, that the ray meets at a t > 0:
// not in the order of the references.
template <class Real, class Stored, class Found>
MASU_ALWAYS_INLINE void meet_triangles(const Triangle<Stored>* triangles, const WatertightRay<Real>& ray,
                                       const PrimitiveIndex* references, std::uint32_t bits,
                                       const Found& found) {
  const WatertightRay<Lanes<Real>> rays{{all_of(ray.origin), all_of(ray.direction), ray.inverse_square},
                                        all_of(ray.across1),
                                        all_of(ray.across2)};
  constexpr std::size_t count = Lanes<Real>::count;
  while (bits != 0) {
    PrimitiveIndex numbers[count];
    numbers[0] = references[std::countr_zero(bits)];
    bits &= bits - 1;
    for (std::size_t i = 1; i < count; ++i) { // the last one again where there are no more
      numbers[i] = bits != 0 ? references[std::countr_zero(bits)] : numbers[i - 1];
      bits &= bits - 1;
    }
    Lanes<Real> each = 0;
    const unsigned hits = intersect(rays, triangles, numbers, each).bits();
    if (hits == 0) continue;
    alignas(32) Real t[count];
    each.store(t);
    each_bit(hits, [&](int i) { found(numbers[i], t[i]); });
  }
}

// Whether a visitor is shown triangles only where the ray meets them.
template <class Visitor>
concept TakesMetTriangles = requires(Visitor visitor) {
  visitor.met(visitor.farthest(), PrimitiveIndex{});
};

// A walk under way. The tests of a node's references come with the next step, and what either needs is
// prefetched.
template <class BoxReal>
class NearestFirstWalk {
public:
  // A ray's origin, and its direction's inverse, bounded.
  template <class Real>
  MASU_ALWAYS_INLINE NearestFirstWalk(const Vec3<Real>& origin, const Vec3<Real>& inverse)
      : ray_(origin, inverse) {}

  // Tests the references that were met last, and visits the next node; false at the end. The visitor is
  // always the same.
  template <class Real, class Visitor>
  MASU_ALWAYS_INLINE bool advance(const HierarchyView<Real>& hierarchy, Visitor& visitor) {
    if (met_ != 0) {
      const PrimitiveIndex* const references = references_;
      if constexpr (TakesMetTriangles<Visitor>)
        meet_triangles(visitor.scene.triangles, visitor.ray, references, met_,
                       [&](PrimitiveIndex number, auto t) { visitor.met(t, number); });
      else
        each_bit(met_, [&](int i) { visitor.primitive(references[i]); });
      met_ = 0;
      if (visitor.ends()) return false;
    }
    const float farthest = in_float32(visitor.farthest());
    while (!(enters_at(next_) <= farthest)) {
      if (end_ == ahead_) return false;
      next_ = *--end_;
    }
    const HierarchyNode& node = hierarchy.nodes[static_cast<std::uint32_t>(next_)];
    const BoxesMet<float> met =
        boxes_met(node, planes_of(node, ray_), ray_, ray_.origin, ray_.inverse, farthest);
    const std::uint32_t slots = met.slots(), nodes = slots & node_slots(node);
    if (slots != nodes) {
      references_ = hierarchy.references + node.first_reference;
      met_ = slots_met(eight_bytes(node.slots), met.lanes) & 0xffffff;
      if constexpr (TakesMetTriangles<Visitor>)
        each_bit(met_, [&](int i) { prefetch(visitor.scene.triangles + references_[i]); });
    }
    if (nodes != 0) {
      next_ = nearest_of(node, nodes, met.enter);
    } else if (end_ != ahead_) {
      next_ = *--end_;
    } else {
      next_ = nothing_ahead;
      return met_ != 0;
    }
    prefetch(hierarchy.nodes + static_cast<std::uint32_t>(next_));
    return true;
  }

private:
  // Of a node's nodes in these slots; the others go to those ahead, the nearest last.
  MASU_ALWAYS_INLINE NodeAhead nearest_of(const HierarchyNode& node, std::uint32_t slots, Floats8 enters) {
    const std::uint32_t siblings = node_slots(node), others = slots & (slots - 1);
    if (others == 0) // its bit is the only one: no need to know where the ray enters it
      return node_ahead(0,
                        node.first_node + static_cast<std::uint32_t>(std::popcount(siblings & (slots - 1))));
    alignas(32) float enter[boxes_per_node];
    enters.store(enter);
    const auto take = [&]() __attribute__((always_inline)) {
      const int slot = std::countr_zero(slots);
      slots &= slots - 1;
      const auto before = static_cast<std::uint32_t>(std::popcount(siblings & ((1U << slot) - 1)));
      return node_ahead(enter[slot], node.first_node + before);
    };
    NodeAhead nearest = take();
    // There is room, but while a mapped file changes: then results are thrown away.
    if (end_ - ahead_ > max_nodes_ahead - (boxes_per_node - 1)) [[unlikely]]
      end_ = ahead_;
    NodeAhead* const begin = end_;
    while (slots != 0) { // NOLINT(bugprone-infinite-loop): take() clears a bit
      const NodeAhead other = take(), farther = std::max(nearest, other);
      nearest = std::min(nearest, other);
      NodeAhead* at = end_++;
      for (; at != begin && at[-1] < farther; --at)
        *at = at[-1];
      *at = farther;
    }
    return nearest;
  }

  BoxRay<BoxReal> ray_;
  NodeAhead next_ = 0; // the root
  const PrimitiveIndex* references_ = nullptr;
  std::uint32_t met_ = 0;            // of the references, a bit each
  NodeAhead ahead_[max_nodes_ahead]; // the nearest of a node's last
  NodeAhead* end_ = ahead_;
};

} // namespace masu
