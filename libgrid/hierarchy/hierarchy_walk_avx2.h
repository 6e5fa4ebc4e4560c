// The walk of a ray through a bounding volume hierarchy on one lane of a processor with AVX2: eight boxes at
// a time, the nodes met from the nearest on, and up to eight triangles at a time. It finds what HierarchyWalk
// (hierarchy_walk.h) finds, to the bit, but may visit other nodes and test other primitives on the way: so
// queries that count take that one. Lists of rays are traced by eight_walks_avx2.h and renderer/cpu/packet.h.
// Host only.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/clip.h"
#include "libscene/geometry/triangle_lanes.h"
#include "libscene/scene_view.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <type_traits>

namespace masu {

// Boxes are met in the arithmetic in which the scene is stored, of which they have the margin. That holds for
// rays in float64, too, of which hits need next to nothing of it: rounding the ray's origin to float32 moves
// it by u M, to which the distances of planes add their 14 u M: far less than 128.
template <class Real, class Visitor>
struct BoxArithmetic {
  using type = Real;
};
template <class Real, class Visitor>
requires requires(const Visitor& visitor) {
  visitor.scene.triangles->a.x;
}
struct BoxArithmetic<Real, Visitor> {
  using type = std::remove_cvref_t<decltype(std::declval<Visitor>().scene.triangles->a.x)>;
};

// What of a ray the test of a node needs.
template <class Real>
struct BoxRay {
  Lanes<Real> origin, inverse; // x, y, z, 0
  // Where in a node the planes begin that the ray meets first and last along each axis, in bytes.
  unsigned near_x, near_y, near_z, far_x, far_y, far_z;

  template <class From>
  MASU_ALWAYS_INLINE BoxRay(const Vec3<From>& from, const Vec3<From>& bounded_inverse)
      : origin(lanes(cast<Real>(from))), inverse(lanes(cast<Real>(bounded_inverse))) {
    constexpr unsigned low = offsetof(HierarchyNode, low), to_high = offsetof(HierarchyNode, high) - low;
    const unsigned down_x = bounded_inverse.x < 0 ? to_high : 0, down_y = bounded_inverse.y < 0 ? to_high : 0,
                   down_z = bounded_inverse.z < 0 ? to_high : 0;
    near_x = low + down_x;
    near_y = low + 8 + down_y;
    near_z = low + 16 + down_z;
    far_x = low + to_high - down_x;
    far_y = low + 8 + to_high - down_y;
    far_z = low + 16 + to_high - down_z;
  }

private:
  MASU_ALWAYS_INLINE static Lanes<Real> lanes(const Vec3<Real>& v) {
    if constexpr (sizeof(Real) == sizeof(float))
      return _mm256_setr_ps(v.x, v.y, v.z, 0, 0, 0, 0, 0);
    else
      return _mm256_setr_pd(v.x, v.y, v.z, 0);
  }
};

// The farthest that boxes may be entered at.
MASU_ALWAYS_INLINE float in_float32(float t) {
  return t;
}
MASU_ALWAYS_INLINE float in_float32(double t) {
  return rounded_up(t);
}

// Of several boxes those that are met: all bits of their lanes; and where they are entered.
template <class Real>
struct BoxesMet {
  LaneMask<Real> lanes;
  Lanes<Real> enter;

  MASU_ALWAYS_INLINE std::uint32_t slots() const { return lanes.bits(); }
};

MASU_ALWAYS_INLINE __m256i eight_bytes(const void* at) {
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(static_cast<const __m128i*>(at)));
}

// A node's planes along each axis as numbers of their units, in the order in which a ray meets them.
struct NodePlanes {
  Vec3<Floats8> near, far;
};
template <class Real>
MASU_ALWAYS_INLINE NodePlanes planes_of(const HierarchyNode& node, const BoxRay<Real>& ray) {
  const char* const bytes = reinterpret_cast<const char*>(&node);
  const auto numbers = [&](unsigned planes) __attribute__((always_inline)) {
    return Floats8(_mm256_cvtepi32_ps(eight_bytes(bytes + planes)));
  };
  return {{numbers(ray.near_x), numbers(ray.near_y), numbers(ray.near_z)},
          {numbers(ray.far_x), numbers(ray.far_y), numbers(ray.far_z)}};
}

// Of several pairs of a box and a ray those that meet as far as `farthest`, by where the ray meets the planes
// of each axis.
template <class Real>
MASU_ALWAYS_INLINE BoxesMet<Real> boxes_met(const Vec3<Lanes<Real>>& near, const Vec3<Lanes<Real>>& far,
                                            std::type_identity_t<Lanes<Real>> farthest) {
  const Lanes<Real> enter = max(max(near.x, near.y), max(near.z, Real(0))),
                    leave = min(min(far.x, far.y), min(far.z, farthest));
  return {enter <= leave, enter};
}

// Of a node's boxes those that are entered by one ray, as far as `farthest`, before they are left by another
// that runs the same way along each axis, or the same one. `enter` is rounded: not beyond `farthest`.
template <class Real>
MASU_ALWAYS_INLINE BoxesMet<float> boxes_met(const HierarchyNode& node, const NodePlanes& planes,
                                             const BoxRay<Real>& entering, const BoxRay<Real>& leaving,
                                             float farthest) {
  const __m128i exponents = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(node.exponents)));
  const auto axes = [](__m128 v) { return part_of<Real>(_mm256_zextps128_ps256(v), 0); };
  const Lanes<Real> origin = axes(_mm_blend_ps(_mm_load_ps(node.origin), _mm_setzero_ps(), 8)),
                    units = axes(_mm_castsi128_ps(_mm_slli_epi32(exponents, 23)));
  // Plane q is met at q · scale + start: with a smaller error than as NodeAxis has it.
  const auto met_at = [&](const BoxRay<Real>& ray, const Vec3<Floats8>& q, std::size_t first)
      __attribute__((always_inline)) {
    const Lanes<Real> scale = units * ray.inverse, start = (origin - ray.origin) * ray.inverse;
    return Vec3<Lanes<Real>>{fma(part_of<Real>(q.x, first), broadcast<0>(scale), broadcast<0>(start)),
                             fma(part_of<Real>(q.y, first), broadcast<1>(scale), broadcast<1>(start)),
                             fma(part_of<Real>(q.z, first), broadcast<2>(scale), broadcast<2>(start))};
  };
  const auto part = [&](std::size_t first) __attribute__((always_inline)) {
    return boxes_met(met_at(entering, planes.near, first), met_at(leaving, planes.far, first),
                     Real(farthest));
  };
  if constexpr (sizeof(Real) == sizeof(float)) {
    return part(0);
  } else {
    const BoxesMet<double> low = part(0), high = part(4);
    return {lanes_of<float>(low.slots() | high.slots() << 4),
            _mm256_set_m128(_mm256_cvtpd_ps(high.enter.v), _mm256_cvtpd_ps(low.enter.v))};
  }
}
template <class Real>
MASU_ALWAYS_INLINE BoxesMet<float> boxes_met(const HierarchyNode& node, const BoxRay<Real>& ray,
                                             float farthest) {
  return boxes_met(node, planes_of(node, ray), ray, ray, farthest);
}

// What of a node is in boxes that the ray meets: bit 24 + slot for a node, and bit i for its reference i. A
// slot's byte is what it adds, shifted (hierarchy.h); an empty one adds nothing.
MASU_ALWAYS_INLINE std::uint32_t slots_met(__m256i slots, LaneMask<float> lanes) {
  const __m256i added =
      _mm256_sllv_epi32(_mm256_srli_epi32(slots, 5), _mm256_and_si256(slots, _mm256_set1_epi32(0x1f)));
  const __m256i met = added & lanes.whole();
  __m128i all = _mm_or_si128(_mm256_castsi256_si128(met), _mm256_extracti128_si256(met, 1));
  all = _mm_or_si128(all, _mm_unpackhi_epi64(all, all));
  all = _mm_or_si128(all, _mm_shuffle_epi32(all, 1));
  return static_cast<std::uint32_t>(_mm_cvtsi128_si32(all));
}

// Calls act(i) for each bit that is set, from the lowest on.
template <class Act>
MASU_ALWAYS_INLINE void each_bit(unsigned bits, const Act& act) {
  for (; bits != 0; bits &= bits - 1)
    act(std::countr_zero(bits));
}

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

// Records of which none has more than two cache lines. Inline always: GCC 12 takes calls of a function that
// only prefetches for calls without effect, and drops them.
template <class Record>
MASU_ALWAYS_INLINE void prefetch(const Record* record) {
  __builtin_prefetch(record);
  __builtin_prefetch(reinterpret_cast<const char*>(record + 1) - 1);
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

template <class Visitor>
concept TakesMetTriangles = requires(Visitor visitor) {
  visitor.met(visitor.farthest(), PrimitiveIndex{});
};

// Shows a visitor references[i] where bit i is set; of triangles only those that the ray meets, where it
// takes them.
template <class Visitor>
MASU_ALWAYS_INLINE void show_references(Visitor& visitor, const PrimitiveIndex* references,
                                        std::uint32_t bits) {
  if constexpr (TakesMetTriangles<Visitor>) {
    meet_triangles(visitor.scene.triangles, visitor.ray, references, bits,
                   [&](PrimitiveIndex number, auto t) { visitor.met(t, number); });
  } else {
    each_bit(bits, [&](int i) { visitor.primitive(references[i]); });
  }
}
template <class Visitor>
MASU_ALWAYS_INLINE void prefetch_references(const Visitor& visitor, const PrimitiveIndex* references,
                                            std::uint32_t bits) {
  if constexpr (TakesMetTriangles<Visitor>) {
    each_bit(bits, [&](int i) { prefetch(visitor.scene.triangles + references[i]); });
  }
}

// The most that a walk has ahead.
inline constexpr int max_nodes_ahead = (boxes_per_node - 1) * max_hierarchy_depth;

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
      show_references(visitor, references_, met_);
      met_ = 0;
      if (visitor.ends()) return false;
    }
    const float farthest = in_float32(visitor.farthest());
    while (!(enters_at(next_) <= farthest)) {
      if (end_ == ahead_) return false;
      next_ = *--end_;
    }
    const HierarchyNode& node = hierarchy.nodes[static_cast<std::uint32_t>(next_)];
    const BoxesMet<float> met = boxes_met(node, ray_, farthest);
    const std::uint32_t slots = met.slots(), nodes = slots & node_slots(node);
    if (slots != nodes) {
      references_ = hierarchy.references + node.first_reference;
      met_ = slots_met(eight_bytes(node.slots), met.lanes) & 0xffffff;
      prefetch_references(visitor, references_, met_);
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
    while (slots != 0) {
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
