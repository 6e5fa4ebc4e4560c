// The walk of a ray through a bounding volume hierarchy on one lane of a processor with AVX2: eight boxes at
// a time, the nodes met from the nearest on, and up to eight triangles at a time. It finds what HierarchyWalk
// (hierarchy_walk.h) finds, to the bit, but may visit other nodes and test other primitives on the way: so
// queries that count take that one. Lists of rays are traced by eight_walks_avx2.h and renderer/cpu/packet.h.
// Host only.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/clip.h"
#include "libscene/geometry/eight_triangles.h"
#include "libscene/scene_view.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cstddef>

namespace masu {

// What of a ray the test of a node needs.
struct BoxRay {
  __m128 origin, inverse; // x, y, z, 0
  // Where in a node the planes begin that the ray meets first and last along each axis, in bytes.
  unsigned near_x, near_y, near_z, far_x, far_y, far_z;

  MASU_ALWAYS_INLINE explicit BoxRay(const Vec3<float>& from, const Vec3<float>& bounded_inverse)
      : origin(_mm_setr_ps(from.x, from.y, from.z, 0)),
        inverse(_mm_setr_ps(bounded_inverse.x, bounded_inverse.y, bounded_inverse.z, 0)) {
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
};

// Of eight boxes those that are met: all bits of their lanes, a bit for each; and where they are entered.
struct BoxesMet {
  __m256 lanes, enter;
  std::uint32_t slots;
};

MASU_ALWAYS_INLINE __m256i eight_bytes(const void* at) {
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(static_cast<const __m128i*>(at)));
}

// A node's planes along each axis as numbers of their units, in the order in which a ray meets them.
struct NodePlanes {
  Vec3<Floats8> near, far;
};
MASU_ALWAYS_INLINE NodePlanes planes_of(const HierarchyNode& node, const BoxRay& ray) {
  const char* const bytes = reinterpret_cast<const char*>(&node);
  const auto numbers = [&](unsigned planes) __attribute__((always_inline)) {
    return Floats8(_mm256_cvtepi32_ps(eight_bytes(bytes + planes)));
  };
  return {{numbers(ray.near_x), numbers(ray.near_y), numbers(ray.near_z)},
          {numbers(ray.far_x), numbers(ray.far_y), numbers(ray.far_z)}};
}

// Of eight pairs of a box and a ray those that meet as far as `farthest`, by where the ray meets the planes
// of each axis.
MASU_ALWAYS_INLINE BoxesMet boxes_met(const Vec3<Floats8>& near, const Vec3<Floats8>& far, Floats8 farthest) {
  const Floats8 enter = max(max(near.x, near.y), max(near.z, Floats8(0.0F))),
                leave = min(min(far.x, far.y), min(far.z, farthest));
  const Mask8 met = enter <= leave;
  return {met.v, enter.v, met.bits()};
}

// Of a node's boxes those that are entered by one ray, as far as `farthest`, before they are left by another
// that runs the same way along each axis, or the same one.
MASU_ALWAYS_INLINE BoxesMet boxes_met(const HierarchyNode& node, const NodePlanes& planes,
                                      const BoxRay& entering, const BoxRay& leaving, float farthest) {
  const __m128 origin = _mm_blend_ps(_mm_load_ps(node.origin), _mm_setzero_ps(), 8);
  const __m128i exponents = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(node.exponents)));
  const __m128 units = _mm_castsi128_ps(_mm_slli_epi32(exponents, 23));
  // Plane q is met at q · scale + start: with a smaller error than as NodeAxis has it.
  const auto met_at = [&](const BoxRay& ray, const Vec3<Floats8>& q) __attribute__((always_inline)) {
    const Floats8 scale = _mm256_castps128_ps256(_mm_mul_ps(units, ray.inverse)),
                  start = _mm256_castps128_ps256(_mm_mul_ps(_mm_sub_ps(origin, ray.origin), ray.inverse));
    const __m256i x = _mm256_set1_epi32(0), y = _mm256_set1_epi32(1), z = _mm256_set1_epi32(2);
    return Vec3<Floats8>{fma(q.x, permuted(scale, x), permuted(start, x)),
                         fma(q.y, permuted(scale, y), permuted(start, y)),
                         fma(q.z, permuted(scale, z), permuted(start, z))};
  };
  return boxes_met(met_at(entering, planes.near), met_at(leaving, planes.far), farthest);
}
MASU_ALWAYS_INLINE BoxesMet boxes_met(const HierarchyNode& node, const BoxRay& ray, float farthest) {
  return boxes_met(node, planes_of(node, ray), ray, ray, farthest);
}

// What of a node is in boxes that the ray meets: bit 24 + slot for a node, and bit i for its reference i. A
// slot's byte is what it adds, shifted (hierarchy.h); an empty one adds nothing.
MASU_ALWAYS_INLINE std::uint32_t slots_met(__m256i slots, __m256 lanes) {
  const __m256i added =
      _mm256_sllv_epi32(_mm256_srli_epi32(slots, 5), _mm256_and_si256(slots, _mm256_set1_epi32(0x1f)));
  const __m256i met = _mm256_and_si256(added, _mm256_castps_si256(lanes));
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
template <class Found>
MASU_ALWAYS_INLINE void meet_triangles(const Triangle<float>* triangles, const WatertightRay<float>& ray,
                                       const PrimitiveIndex* references, std::uint32_t bits,
                                       const Found& found) {
  const WatertightRay<Floats8> rays{{all_of(ray.origin), all_of(ray.direction), ray.inverse_square},
                                    all_of(ray.across1),
                                    all_of(ray.across2)};
  while (bits != 0) {
    PrimitiveIndex eight[8];
    eight[0] = references[std::countr_zero(bits)];
    bits &= bits - 1;
    for (int i = 1; i < 8; ++i) { // the last one again where there are no more
      eight[i] = bits != 0 ? references[std::countr_zero(bits)] : eight[i - 1];
      bits &= bits - 1;
    }
    Floats8 each = 0;
    const unsigned hits = intersect(rays, triangles, eight, each).bits();
    if (hits == 0) continue;
    alignas(32) float t[8];
    each.store(t);
    each_bit(hits, [&](int i) { found(eight[i], t[i]); });
  }
}

template <class Visitor>
concept TakesMetTriangles = requires(Visitor visitor) {
  visitor.met(0.0F, PrimitiveIndex{});
};

// Shows a visitor references[i] where bit i is set; of triangles only those that the ray meets, where it
// takes them.
template <class Visitor>
MASU_ALWAYS_INLINE void show_references(Visitor& visitor, const PrimitiveIndex* references,
                                        std::uint32_t bits) {
  if constexpr (TakesMetTriangles<Visitor>) {
    meet_triangles(visitor.scene.triangles, visitor.ray, references, bits,
                   [&](PrimitiveIndex number, float t) { visitor.met(t, number); });
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
class NearestFirstWalk {
public:
  // A ray's origin, and its direction's inverse, bounded.
  MASU_ALWAYS_INLINE NearestFirstWalk(const Vec3<float>& origin, const Vec3<float>& inverse)
      : ray_(origin, inverse) {}

  // Tests the references that were met last, and visits the next node; false at the end. The visitor is
  // always the same.
  template <class Visitor>
  MASU_ALWAYS_INLINE bool advance(const HierarchyView<float>& hierarchy, Visitor& visitor) {
    if (met_ != 0) {
      show_references(visitor, references_, met_);
      met_ = 0;
      if (visitor.ends()) return false;
    }
    const float farthest = visitor.farthest();
    while (!(enters_at(next_) <= farthest)) {
      if (end_ == ahead_) return false;
      next_ = *--end_;
    }
    const HierarchyNode& node = hierarchy.nodes[static_cast<std::uint32_t>(next_)];
    const BoxesMet met = boxes_met(node, ray_, farthest);
    const std::uint32_t nodes = met.slots & node_slots(node);
    if (met.slots != nodes) {
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
  MASU_ALWAYS_INLINE NodeAhead nearest_of(const HierarchyNode& node, std::uint32_t slots, __m256 enters) {
    const std::uint32_t siblings = node_slots(node), others = slots & (slots - 1);
    if (others == 0) // its bit is the only one: no need to know where the ray enters it
      return node_ahead(0,
                        node.first_node + static_cast<std::uint32_t>(std::popcount(siblings & (slots - 1))));
    alignas(32) float enter[boxes_per_node];
    _mm256_store_ps(enter, enters);
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

  BoxRay ray_;
  NodeAhead next_ = 0; // the root
  const PrimitiveIndex* references_ = nullptr;
  std::uint32_t met_ = 0;            // of the references, a bit each
  NodeAhead ahead_[max_nodes_ahead]; // the nearest of a node's last
  NodeAhead* end_ = ahead_;
};

} // namespace masu
