// Which boxes of a node are closest to a place: what a search for closest points visits next. Distances are
// squared and in double, with a few roundings of the largest coordinate.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#ifdef MASU_HOST_AVX2
#include "libscene/geometry/lanes.h"

#include <bit>
#endif

namespace masu {

#ifdef MASU_HOST_AVX2

// Slots of a node by the squared distances of their boxes. Of those not taken yet, keys_ has the highest
// bits, without the sign; else all bits are set.
class SlotsByDistance {
  alignas(32) double squared_[boxes_per_node]; // of even slots, then of odd ones
  __m128i keys_;
  static constexpr int dropped = 47;

  static __m256i key(const Lanes<double>& squared) { return _mm256_srli_epi64(squared.whole(), dropped); }

public:
  SlotsByDistance() = default;
  SlotsByDistance(const HierarchyNode& node, const Vec3d& place, double) {
    Lanes<double> even = 0.0, odd = 0.0;
    const auto load = [](const std::uint32_t(&eight)[2]) {
      return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(eight));
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes<double> unit = static_cast<double>(float_of((node.exponents >> (8 * axis) & 0xff) << 23)),
                          from = place[axis] - static_cast<double>(node.origin[axis]);
      const __m128i low = _mm_cvtepu16_epi32(load(node.low[axis])),
                    high = _mm_cvtepu16_epi32(load(node.high[axis]));
      const auto add = [&](Lanes<double>& sum, __m128i lows, __m128i highs) {
        const Lanes<double> below = unit * _mm256_cvtepi32_pd(lows) - from,
                            above = from - unit * _mm256_cvtepi32_pd(highs);
        const Lanes<double> away = max(max(below, above), Lanes<double>(0.0));
        sum = fma(away, away, sum);
      };
      const __m128i byte = _mm_set1_epi32(0xff);
      add(even, _mm_and_si128(low, byte), _mm_and_si128(high, byte));
      add(odd, _mm_srli_epi32(low, 8), _mm_srli_epi32(high, 8));
    }
    even.store(squared_);
    odd.store(squared_ + 4);
    const __m256i both = _mm256_or_si256(key(even), _mm256_slli_epi64(key(odd), 32));
    keys_ = _mm_packus_epi32(_mm256_castsi256_si128(both), _mm256_extracti128_si256(both, 1)) |
            _mm_cvtepi8_epi16(_mm_cmpeq_epi8(load(node.slots), _mm_setzero_si128()));
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
      if (squared_[(slot & 1) * 4 + slot / 2] <= farthest) return true;
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
