// The walk of a ray through a bounding volume hierarchy: node by node, from near to far; after Ylitie, Karras
// & Laine (hierarchy_view.h).
//
// Results are independent of the hierarchy. A primitive's box contains its surface and the builder's margin
// (libscene/geometry/margin.h) around it. So a computed hit lies at least 39 u M inside its boxes, and the
// distance of a plane is off by less than 14 u M along its axis, and besides by 3 · 2^-9 units of the node,
// for which the builder makes boxes larger by 2^-6 units: a ray is never found to miss the box of what it
// hits, nor to enter it beyond the hit.
#pragma once

#include "libgrid/trace/hierarchy_view.h"
#include "libscene/geometry/clip.h"

#ifdef MASU_HOST_AVX2
#include "libgrid/trace/hierarchy_walk_avx2.h"
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

// A bit an axis: set where the ray runs upwards.
template <class Real>
MASU_HD inline std::uint32_t octant_of(const Vec3<Real>& inverse) {
  return (inverse.x < 0 ? 0U : 1U) | (inverse.y < 0 ? 0U : 2U) | (inverse.z < 0 ? 0U : 4U);
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

// What a ray meets of a node: bit 24 + (slot ^ octant) for a node, so that the highest is visited first, and
// bit i for reference i of the node's.
#ifdef __CUDA_ARCH__
template <int byte>
__device__ inline float plane_of(std::uint32_t planes) {
  return __uint_as_float(__byte_perm(planes, plane_offset_bits, 0x7604 | byte << 4));
}
template <class Real>
__device__ inline std::uint32_t
met_of_four(const NodeAxis<Real>& x, const NodeAxis<Real>& y, const NodeAxis<Real>& z, std::uint32_t near_x,
            std::uint32_t far_x, std::uint32_t near_y, std::uint32_t far_y, std::uint32_t near_z,
            std::uint32_t far_z, std::uint32_t slots, std::uint32_t octants, Real t_max) {
  // Four slots at a time: those of nodes have bits 3 and 4 set; all bits of their bytes.
  const std::uint32_t is_node = (slots & slots << 1) & 0x10101010;
  std::uint32_t nodes;
  asm("prmt.b32 %0, %1, 0, 0xba98;" : "=r"(nodes) : "r"(is_node << 3));
  const std::uint32_t shifts = (slots ^ (octants & nodes)) & 0x1f1f1f1f, unary = slots >> 5 & 0x07070707;
  std::uint32_t met = 0;
  const auto test = [&]<int i>(std::integral_constant<int, i>) {
    const Real enter = fast_max(fast_max(fma(Real(plane_of<i>(near_x)), x.scale, x.start),
                                         fma(Real(plane_of<i>(near_y)), y.scale, y.start)),
                                fast_max(fma(Real(plane_of<i>(near_z)), z.scale, z.start), Real(0)));
    const Real leave = fast_min(fast_min(fma(Real(plane_of<i>(far_x)), x.scale, x.start),
                                         fma(Real(plane_of<i>(far_y)), y.scale, y.start)),
                                fast_min(fma(Real(plane_of<i>(far_z)), z.scale, z.start), t_max));
    if (enter <= leave) met |= (unary >> (8 * i) & 0xff) << (shifts >> (8 * i) & 0xff);
  };
  test(std::integral_constant<int, 0>{});
  test(std::integral_constant<int, 1>{});
  test(std::integral_constant<int, 2>{});
  test(std::integral_constant<int, 3>{});
  return met;
}
#endif

MASU_HD inline std::uint32_t met_bits(std::uint32_t slot, std::uint32_t octant) {
  return (slot & 0x18) == 0x18 ? 1U << ((slot & 0x1f) ^ octant) : slot >> 5 << (slot & 0x1f);
}

template <class Real>
MASU_HD inline std::uint32_t boxes_met(const HierarchyNode& node, const Vec3<Real>& origin,
                                       const Vec3<Real>& inverse, std::uint32_t octant, Real t_max) {
  const std::uint32_t e = node.exponents;
  const NodeAxis<Real> x = node_axis(node.origin[0], e & 0xff, origin.x, inverse.x),
                       y = node_axis(node.origin[1], e >> 8 & 0xff, origin.y, inverse.y),
                       z = node_axis(node.origin[2], e >> 16 & 0xff, origin.z, inverse.z);
  const bool up_x = (octant & 1) != 0, up_y = (octant & 2) != 0, up_z = (octant & 4) != 0;
#ifdef __CUDA_ARCH__
  const std::uint32_t octants = octant * 0x01010101U;
  std::uint32_t met = 0;
#pragma unroll
  for (int half = 0; half < 2; ++half) {
    const std::uint32_t lx = node.low[0][half], hx = node.high[0][half], ly = node.low[1][half],
                        hy = node.high[1][half], lz = node.low[2][half], hz = node.high[2][half];
    met |= met_of_four(x, y, z, up_x ? lx : hx, up_x ? hx : lx, up_y ? ly : hy, up_y ? hy : ly,
                       up_z ? lz : hz, up_z ? hz : lz, node.slots[half], octants, t_max);
  }
  return met;
#else
  const auto& near_x = up_x ? node.low[0] : node.high[0];
  const auto& far_x = up_x ? node.high[0] : node.low[0];
  const auto& near_y = up_y ? node.low[1] : node.high[1];
  const auto& far_y = up_y ? node.high[1] : node.low[1];
  const auto& near_z = up_z ? node.low[2] : node.high[2];
  const auto& far_z = up_z ? node.high[2] : node.low[2];
  std::uint32_t met = 0;
#ifdef MASU_HOST_AVX2
  if constexpr (sizeof(Real) == sizeof(float)) {
    const auto t = [](const std::uint32_t(&planes)[2], const NodeAxis<float>& axis) {
      const __m256i bytes = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(planes)));
      const __m256i bits = _mm256_or_si256(_mm256_slli_epi32(bytes, 8), _mm256_set1_epi32(plane_offset_bits));
      return _mm256_fmadd_ps(_mm256_castsi256_ps(bits), _mm256_set1_ps(axis.scale),
                             _mm256_set1_ps(axis.start));
    };
    const __m256 enter = _mm256_max_ps(_mm256_max_ps(t(near_x, x), t(near_y, y)),
                                       _mm256_max_ps(t(near_z, z), _mm256_setzero_ps())),
                 leave = _mm256_min_ps(_mm256_min_ps(t(far_x, x), t(far_y, y)),
                                       _mm256_min_ps(t(far_z, z), _mm256_set1_ps(t_max)));
    for (auto hit = static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
         hit != 0; hit &= hit - 1) {
      const int slot = std::countr_zero(hit);
      met |= met_bits(slot_byte(node.slots, slot), octant);
    }
    return met;
  }
#endif
  const auto t = [](const std::uint32_t(&planes)[2], int slot, const NodeAxis<Real>& axis) {
    return fma(static_cast<Real>(float_of(plane_offset_bits | slot_byte(planes, slot) << 8)), axis.scale,
               axis.start);
  };
  for (int slot = 0; slot < boxes_a_node; ++slot) {
    const Real enter = fast_max(fast_max(t(near_x, slot, x), t(near_y, slot, y)),
                                fast_max(t(near_z, slot, z), Real(0))),
               leave = fast_min(fast_min(t(far_x, slot, x), t(far_y, slot, y)),
                                fast_min(t(far_z, slot, z), t_max));
    if (enter <= leave) met |= met_bits(slot_byte(node.slots, slot), octant);
  }
  return met;
#endif
}

// What is still to be visited: nodes from `first` on, by the bits above 23 (boxes_met) and the mask of slots
// that hold nodes below; or references from `first` on, by the bits below 24, where no bit above is set.
struct HierarchyGroup {
  std::uint32_t first, bits;
  MASU_HD bool has_nodes() const { return bits > 0xffffff; }
};

MASU_HD inline int highest_bit(std::uint32_t bits) { // of a number other than 0
#ifdef __CUDA_ARCH__
  return 31 - __clz(static_cast<int>(bits));
#else
  return 31 - std::countl_zero(bits);
#endif
}

// What a walk comes back to. A node pushes at most what it holds besides the node visited next, and the tests
// put off. It isn't part of the walk: a struct that holds an array which is indexed lies in memory as a
// whole, where registers should hold the rest.
using HierarchyStack = HierarchyGroup[2 * max_hierarchy_depth];

template <class Real, class Visitor>
MASU_HD inline void show(const HierarchyView<Real>& hierarchy, std::uint32_t reference, Visitor& visitor) {
  visitor.primitive(hierarchy.references[reference]);
}
template <class Real, class Stored, class Visitor>
MASU_HD inline void show(const LeafHierarchyView<Real, Stored>& hierarchy, std::uint32_t reference,
                         Visitor& visitor) {
  visitor.triangle(hierarchy.triangles + reference);
}

// A walk under way.
template <class Real>
struct HierarchyWalk {
  Vec3<Real> inverse; // bounded
  HierarchyGroup nodes, references;
  int height; // of the stack

  MASU_HD void begin(const ClippedRay<Real>& near) {
    inverse = bounded_inverse(near);
    nodes = {0, 0x80000000U}; // the root, in the first place for any ray
    references = {0, 0};
    height = 0;
  }

  // Visits the next node of the visitor's ray, and shows the visitor the references in the boxes that the ray
  // meets; false at the end. Tests are put off where few of a warp's lanes have any (after Ylitie, Karras &
  // Laine), unless the visitor counts: what is visited would depend on that.
  template <class Hierarchy, class Visitor>
  MASU_HD bool advance(const Hierarchy& hierarchy, HierarchyStack& stack, Visitor& visitor) {
    if (nodes.has_nodes()) {
      const int next = highest_bit(nodes.bits);
      const std::uint32_t first = nodes.first, siblings = nodes.bits & 0xff;
      nodes.bits &= ~(1U << next);
      if (nodes.has_nodes()) stack[height++] = nodes;
      const std::uint32_t octant = octant_of(inverse), slot = static_cast<std::uint32_t>(next - 24) ^ octant;
      const std::uint32_t before = siblings & ~(~0U << slot);
#ifdef __CUDA_ARCH__
      const HierarchyNode node = fetched(hierarchy.nodes + first + __popc(before));
#else
      const HierarchyNode& node = hierarchy.nodes[first + static_cast<std::uint32_t>(std::popcount(before))];
#endif
      const std::uint32_t met = boxes_met(node, visitor.ray.origin, inverse, octant, visitor.farthest());
      visitor.counts.cell(met == 0);
      nodes = {node.first_node, (met & 0xff000000U) | node_slots(node)};
      references = {node.first_reference, met & 0xffffff};
    } else {
      references = nodes;
      nodes.bits = 0;
    }
#ifdef __CUDA_ARCH__
    const int testing = __popc(__activemask());
#endif
    while (references.bits != 0) {
#ifdef __CUDA_ARCH__
      if (!visitor.counts.is_counted && __popc(__activemask()) * 5 < testing) {
        stack[height++] = references;
        break;
      }
#endif
      const int next = highest_bit(references.bits);
      references.bits &= ~(1U << next);
      show(hierarchy, references.first + static_cast<std::uint32_t>(next), visitor);
    }
    if (visitor.ends()) return false;
    if (!nodes.has_nodes()) {
      if (height == 0) return false;
      nodes = stack[--height];
    }
    return true;
  }
};

template <class Real, class Visitor>
MASU_HD inline void visit(const HierarchyView<Real>& hierarchy, const ClippedRay<Real>& near, std::uint32_t,
                          Visitor& visitor) {
#ifdef MASU_HOST_AVX2
  if constexpr (sizeof(Real) == sizeof(float) && !std::decay_t<decltype(visitor.counts)>::is_counted) {
    NodesAhead ahead;
    NearestFirstWalk walk(visitor.ray.origin, bounded_inverse(near), ahead);
    while (walk.advance(hierarchy, visitor)) {
    }
    return;
  }
#endif
  HierarchyStack stack;
  HierarchyWalk<Real> walk;
  walk.begin(near);
  while (walk.advance(hierarchy, stack, visitor)) {
  }
}
template <class Real, class Stored, class Visitor>
MASU_HD inline void visit(const LeafHierarchyView<Real, Stored>& hierarchy, const ClippedRay<Real>& near,
                          std::uint32_t, Visitor& visitor) {
  HierarchyStack stack;
  HierarchyWalk<Real> walk;
  walk.begin(near);
  while (walk.advance(hierarchy, stack, visitor)) {
  }
}

} // namespace masu
