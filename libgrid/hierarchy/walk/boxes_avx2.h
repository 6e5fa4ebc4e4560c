// What rays meet of a node's boxes on a processor with AVX2: eight boxes at a time. Host only.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/lanes.h"

#include <immintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

namespace masu {

// x, y, z, 0
template <class Real, class From>
MASU_ALWAYS_INLINE Lanes<Real> axes_of(const Vec3<From>& from) {
  const Vec3<Real> v = cast<Real>(from);
  if constexpr (sizeof(Real) == sizeof(float))
    return _mm256_setr_ps(v.x, v.y, v.z, 0, 0, 0, 0, 0);
  else
    return _mm256_setr_pd(v.x, v.y, v.z, 0);
}

// Where in a node the planes begin that a ray meets first and last along each axis, in bytes.
struct PlanesMet {
  unsigned near_x = 0, near_y = 0, near_z = 0, far_x = 0, far_y = 0, far_z = 0;
};
// What of a ray the test of a node needs.
template <class Real>
struct BoxRay {
  Lanes<Real> origin, inverse; // as axes_of() has them, with whatever in the fourth lane
  PlanesMet planes;

  MASU_ALWAYS_INLINE BoxRay(Lanes<Real> from, Lanes<Real> bounded_inverse)
      : origin(from), inverse(bounded_inverse),
        planes(planes_met[LaneMask<Real>(bounded_inverse.v).bits() & 7]) {}
  template <class From>
  MASU_ALWAYS_INLINE BoxRay(const Vec3<From>& from, const Vec3<From>& bounded_inverse)
      : BoxRay(axes_of<Real>(from), axes_of<Real>(bounded_inverse)) {}
  BoxRay() : BoxRay(Vec3<Real>{0, 0, 0}, Vec3<Real>{1, 1, 1}) {} // any

private:
  // By the axes along which the ray goes down, a bit each.
  static constexpr auto planes_met = [] {
    constexpr unsigned low = offsetof(HierarchyNode, low), to_high = offsetof(HierarchyNode, high) - low;
    std::array<PlanesMet, 8> met{};
    for (unsigned down = 0; down < 8; ++down) {
      const unsigned x = down & 1 ? to_high : 0, y = down & 2 ? to_high : 0, z = down & 4 ? to_high : 0;
      met[down] = {low + x,           low + 8 + y,           low + 16 + z,
                   low + to_high - x, low + 8 + to_high - y, low + 16 + to_high - z};
    }
    return met;
  }();
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
  const PlanesMet& met = ray.planes;
  return {{numbers(met.near_x), numbers(met.near_y), numbers(met.near_z)},
          {numbers(met.far_x), numbers(met.far_y), numbers(met.far_z)}};
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
// that runs the same way along each axis, or the same one: of which two lanes are given, not a ray, since
// compilers copy a ray through memory. `enter` is rounded: not beyond `farthest`.
template <class Real>
MASU_ALWAYS_INLINE BoxesMet<float> boxes_met(const HierarchyNode& node, const NodePlanes& planes,
                                             const BoxRay<Real>& entering, Lanes<Real> leaving_origin,
                                             Lanes<Real> leaving_inverse, float farthest) {
  const __m128i exponents = _mm_cvtepu8_epi32(_mm_cvtsi32_si128(static_cast<int>(node.exponents)));
  const auto axes = [](__m128 v) { return part_of<Real>(_mm256_castps128_ps256(v), 0); };
  const Lanes<Real> origin = axes(_mm_blend_ps(_mm_load_ps(node.origin), _mm_setzero_ps(), 8)),
                    units = axes(_mm_castsi128_ps(_mm_slli_epi32(exponents, 23)));
  // Plane q is met at q · scale + start: with a smaller error than as NodeAxis has it.
  const auto met_at = [&](Lanes<Real> from, Lanes<Real> inverse, const Vec3<Floats8>& q, std::size_t first)
      __attribute__((always_inline)) {
    const Lanes<Real> scale = units * inverse, start = (origin - from) * inverse;
    return Vec3<Lanes<Real>>{fma(part_of<Real>(q.x, first), broadcast<0>(scale), broadcast<0>(start)),
                             fma(part_of<Real>(q.y, first), broadcast<1>(scale), broadcast<1>(start)),
                             fma(part_of<Real>(q.z, first), broadcast<2>(scale), broadcast<2>(start))};
  };
  const auto part = [&](std::size_t first) __attribute__((always_inline)) {
    return boxes_met(met_at(entering.origin, entering.inverse, planes.near, first),
                     met_at(leaving_origin, leaving_inverse, planes.far, first), Real(farthest));
  };
  if constexpr (sizeof(Real) == sizeof(float)) {
    return part(0);
  } else {
    const BoxesMet<double> low = part(0), high = part(4);
    return {lanes_of<float>(low.slots() | high.slots() << 4),
            _mm256_set_m128(_mm256_cvtpd_ps(high.enter.v), _mm256_cvtpd_ps(low.enter.v))};
  }
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
