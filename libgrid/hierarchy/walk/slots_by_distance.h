// Which boxes of a node are closest to a place: what a search for closest points visits next. Distances are
// squared and in double, with a few roundings of the largest coordinate.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#ifdef MASU_HOST_AVX2
#include "libgrid/hierarchy/walk/boxes_avx2.h"
#endif

namespace masu {

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

} // namespace masu
