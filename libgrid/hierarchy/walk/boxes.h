// What a ray meets of a node's boxes, for one ray on any processor, and for lanes of a GPU. On processors
// with AVX2 walks that don't count use boxes_avx2.h.
//
// Results are independent of the hierarchy. A primitive's box contains its surface and the builder's margin
// (libscene/geometry/margin.h) around it. So a computed hit lies at least 39 u M inside its boxes, and the
// distance of a plane is off by less than 14 u M along its axis, and besides by 3 · 2^-9 units of the node,
// for which the builder makes boxes larger by 2^-6 units: a ray is never found to miss the box of what it
// hits, nor to enter it beyond the hit.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/clip.h"

#ifdef MASU_HOST_AVX2
#include "libgrid/hierarchy/walk/boxes_avx2.h"
#endif

namespace masu {

// The inverse of a direction, bounded so that no product with it overflows: what a ray moves along an axis
// that is slower than 2^-64 is far below a rounding.
template <class Real>
MASU_HD inline Vec3<Real> bounded_inverse(const ClippedRay<Real>& near) {
  constexpr Real limit = 0x1p64F;
  const auto bounded = [](Real inverse) { return fast_min(fast_max(inverse, -limit), limit); };
  return {bounded(near.inverse.x), bounded(near.inverse.y), bounded(near.inverse.z)};
}

// Along one axis: plane q of a node is met at t = (2^15 + q) · scale + start. A float whose bits are those of
// 2^15 with q in its second byte is just that sum: no conversion is needed.
template <class Real>
struct NodeAxis {
  Real scale, start;
};
inline constexpr std::uint32_t plane_offset_bits = 0x47000000; // of 2^15
inline constexpr float plane_offset = 0x1p15F;

template <class Real>
MASU_HD inline NodeAxis<Real> node_axis(float origin, std::uint32_t exponent, Real from, Real inverse) {
  const Real scale = static_cast<Real>(float_of(exponent << 23)) * inverse;
  return {scale, fma(Real(-plane_offset), scale, (static_cast<Real>(origin) - from) * inverse)};
}

template <class Real>
using NodeAxes = Vec3<NodeAxis<Real>>;
template <class Real>
MASU_HD inline NodeAxes<Real> node_axes(const HierarchyNode& node, const Vec3<Real>& origin,
                                        const Vec3<Real>& inverse) {
  const std::uint32_t e = node.exponents;
  return {node_axis(node.origin[0], e & 0xff, origin.x, inverse.x),
          node_axis(node.origin[1], e >> 8 & 0xff, origin.y, inverse.y),
          node_axis(node.origin[2], e >> 16 & 0xff, origin.z, inverse.z)};
}

// How far planes are moved outwards: not at all; or as far along each axis, for rays that were carried into
// the boxes' space by roundings.
struct NoPadding {};

template <class Real>
struct PaddedAxes {
  NodeAxes<Real> near, far; // of the planes by which a ray enters and leaves
};
template <class Real>
MASU_HD inline PaddedAxes<Real> padded(const NodeAxes<Real>& axes, const Vec3<Real>&, NoPadding) {
  return {axes, axes};
}
template <class Real>
MASU_HD inline PaddedAxes<Real> padded(const NodeAxes<Real>& axes, const Vec3<Real>& inverse, Real by) {
  PaddedAxes<Real> moved{axes, axes};
  const Vec3<Real> t{by * std::abs(inverse.x), by * std::abs(inverse.y), by * std::abs(inverse.z)};
  moved.near.x.start -= t.x;
  moved.near.y.start -= t.y;
  moved.near.z.start -= t.z;
  moved.far.x.start += t.x;
  moved.far.y.start += t.y;
  moved.far.z.start += t.z;
  return moved;
}

// Where a ray enters a box, t >= 0, as a whole number: in the same order, and rounded down.
MASU_HD inline std::uint32_t entry_bits(float t) {
  return bits_of(t) & 0x7fffffffU; // -0 is 0
}
MASU_HD inline std::uint32_t entry_bits(double t) {
  const auto rounded = static_cast<float>(t);
  return entry_bits(rounded) - (static_cast<double>(rounded) > t ? 1 : 0);
}

// What a ray meets of a node.
struct MetBoxes {
  static constexpr std::uint32_t none = ~0U, slot_bits = 7;

  // Bit 24 + slot for a node, and bit i for reference i of the node's.
  std::uint32_t bits = 0;
  // Of its nodes the two that the ray enters first: entry_bits() with the slot in the last three.
  std::uint32_t nearest = none, second = none;

  MASU_HD void enter(std::uint32_t entry) {
#ifdef __CUDA_ARCH__
    second = ::min(second, ::max(nearest, entry));
    nearest = ::min(nearest, entry);
#else
    second = std::min(second, std::max(nearest, entry));
    nearest = std::min(nearest, entry);
#endif
  }
};

#ifdef __CUDACC__
// 2^15 with the plane's number, of four planes.
__device__ inline float plane_of(std::uint32_t planes, unsigned byte) {
  return __uint_as_float(__byte_perm(planes, plane_offset_bits, 0x7604 | byte << 4));
}

// Whether a ray is within three pairs of planes at the same time, between 0 and t_max, and from where on. In
// float32 whole numbers are compared, of which the processor takes three at once: negative floats are
// negative numbers, in whatever order; -0 and NaN don't occur, since nothing overflows and sums of multiples
// of the least float aren't rounded to 0.
__device__ inline bool overlap(float x0, float x1, float y0, float y1, float z0, float z1, float t_max,
                               std::uint32_t& entry) {
  const int enter = __vimax3_s32_relu(__float_as_int(x0), __float_as_int(y0), __float_as_int(z0));
  const int leave =
      ::min(__vimin3_s32(__float_as_int(x1), __float_as_int(y1), __float_as_int(z1)), __float_as_int(t_max));
  entry = static_cast<std::uint32_t>(enter);
  return enter <= leave;
}
__device__ inline bool overlap(double x0, double x1, double y0, double y1, double z0, double z1, double t_max,
                               std::uint32_t& entry) {
  const double enter = fast_max(fast_max(x0, y0), fast_max(z0, 0.0));
  entry = entry_bits(enter);
  return enter <= fast_min(fast_min(x1, y1), fast_min(z1, t_max));
}

// Slots first to first + 3. Rays of a warp that are alike miss the same boxes: what follows a box that is met
// is behind a branch.
template <int first, class Real>
__device__ inline void meet_four(MetBoxes& met, const NodeAxes<Real>& near, const NodeAxes<Real>& far,
                                 std::uint32_t near_x, std::uint32_t far_x, std::uint32_t near_y,
                                 std::uint32_t far_y, std::uint32_t near_z, std::uint32_t far_z,
                                 std::uint32_t slots, Real t_max) {
  // Four slots at a time: those of nodes have bits 3 and 4 set; all bits of the others' bytes.
  const std::uint32_t is_node = (slots & slots << 1) & 0x10101010;
  std::uint32_t others;
  asm("prmt.b32 %0, %1, 0, 0xba98;" : "=r"(others) : "r"(~(is_node << 3)));
  // A node's number, or what makes `none` of an entry.
  std::uint32_t numbers = others | (0x03020100 + first * 0x01010101);
  asm("" : "+r"(numbers)); // once, not for each box
  const auto test = [&]<int i>(std::integral_constant<int, i>) {
    std::uint32_t entry;
    const auto t = [](std::uint32_t planes, const NodeAxis<Real>& axis) {
      return fma(Real(plane_of(planes, i)), axis.scale, axis.start);
    };
    if (!overlap(t(near_x, near.x), t(far_x, far.x), t(near_y, near.y), t(far_y, far.y), t(near_z, near.z),
                 t(far_z, far.z), t_max, entry))
      return;
    // Of a node `unary` is 1, and shifted by 24 + slot.
    const std::uint32_t held = slots >> (8 * i);
    met.bits |= __funnelshift_l(0, held >> 5 & 7, held);
    met.enter((entry & ~MetBoxes::slot_bits) | __byte_perm(numbers, others, 0x4440 + i * 0x1111));
  };
  test(std::integral_constant<int, 0>{});
  test(std::integral_constant<int, 1>{});
  test(std::integral_constant<int, 2>{});
  test(std::integral_constant<int, 3>{});
}
#endif

// What a slot holds, as MetBoxes has it.
MASU_HD inline std::uint32_t met_bits(std::uint32_t slot) {
  return slot >> 5 << (slot & 0x1f);
}

template <class Real, class Padding = NoPadding>
MASU_HD inline MetBoxes boxes_met(const HierarchyNode& node, const Vec3<Real>& origin,
                                  const Vec3<Real>& inverse, Real t_max, const Padding& padding = {}) {
  const PaddedAxes<Real> axes = padded(node_axes(node, origin, inverse), inverse, padding);
  const NodeAxes<Real>&near = axes.near, &far = axes.far;
  const bool up_x = inverse.x >= 0, up_y = inverse.y >= 0, up_z = inverse.z >= 0;
  MetBoxes met;
#ifdef __CUDA_ARCH__
  const auto half = [&]<int i>(std::integral_constant<int, i>) {
    const std::uint32_t lx = node.low[0][i], hx = node.high[0][i], ly = node.low[1][i], hy = node.high[1][i],
                        lz = node.low[2][i], hz = node.high[2][i];
    meet_four<4 * i>(met, near, far, up_x ? lx : hx, up_x ? hx : lx, up_y ? ly : hy, up_y ? hy : ly,
                     up_z ? lz : hz, up_z ? hz : lz, node.slots[i], t_max);
  };
  half(std::integral_constant<int, 0>{});
  half(std::integral_constant<int, 1>{});
#else
  const auto& near_x = up_x ? node.low[0] : node.high[0];
  const auto& far_x = up_x ? node.high[0] : node.low[0];
  const auto& near_y = up_y ? node.low[1] : node.high[1];
  const auto& far_y = up_y ? node.high[1] : node.low[1];
  const auto& near_z = up_z ? node.low[2] : node.high[2];
  const auto& far_z = up_z ? node.high[2] : node.low[2];
  const auto meet = [&](int slot, Real enter) {
    met.bits |= met_bits(slot_byte(node.slots, slot));
    if ((node_slots(node) >> slot & 1) != 0)
      met.enter((entry_bits(enter) & ~MetBoxes::slot_bits) | static_cast<std::uint32_t>(slot));
  };
#ifdef MASU_HOST_AVX2
  using Planes = Lanes<Real>; // counted walks take two thirds of the time
  for (std::size_t first = 0; first < boxes_per_node; first += Planes::count) {
    const auto t = [&](const std::uint32_t(&planes)[2], const NodeAxis<Real>& axis) {
      const __m256i bits = _mm256_slli_epi32(eight_bytes(planes), 8) | _mm256_set1_epi32(plane_offset_bits);
      return fma(part_of<Real>(_mm256_castsi256_ps(bits), first), axis.scale, axis.start);
    };
    const BoxesMet<Real> boxes = boxes_met<Real>({t(near_x, near.x), t(near_y, near.y), t(near_z, near.z)},
                                                 {t(far_x, far.x), t(far_y, far.y), t(far_z, far.z)}, t_max);
    alignas(32) Real enter[Planes::count];
    boxes.enter.store(enter);
    each_bit(boxes.slots(), [&](int slot) { meet(static_cast<int>(first) + slot, enter[slot]); });
  }
#else
  const auto t = [](const std::uint32_t(&planes)[2], int slot, const NodeAxis<Real>& axis) {
    return fma(static_cast<Real>(float_of(plane_offset_bits | slot_byte(planes, slot) << 8)), axis.scale,
               axis.start);
  };
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    const Real enter = fast_max(fast_max(t(near_x, slot, near.x), t(near_y, slot, near.y)),
                                fast_max(t(near_z, slot, near.z), Real(0))),
               leave = fast_min(fast_min(t(far_x, slot, far.x), t(far_y, slot, far.y)),
                                fast_min(t(far_z, slot, far.z), t_max));
    if (enter <= leave) meet(slot, enter);
  }
#endif
#endif
  return met;
}

} // namespace masu
