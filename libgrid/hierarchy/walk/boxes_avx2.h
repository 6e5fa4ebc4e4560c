// What rays meet of a node's boxes on a processor with AVX2: eight boxes at a time. Host only.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/base/fetch.h"
#include "libscene/geometry/lanes.h"

#include <immintrin.h>

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
  unsigned near_x = 0, near_y = 0, near_z = 0, far_x = 0, far_y = 0, far_z = 0;

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
  BoxRay() : BoxRay(Vec3<Real>{0, 0, 0}, Vec3<Real>{1, 1, 1}) {} // any

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

MASU_ALWAYS_INLINE __m256i load_eight(const void* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(from));
}
MASU_ALWAYS_INLINE void store_eight(void* to, __m256i eight) {
  _mm256_storeu_si256(static_cast<__m256i*>(to), eight);
}
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

// The most that a walk has ahead.
inline constexpr int max_nodes_ahead = (boxes_per_node - 1) * max_hierarchy_depth;

} // namespace masu
