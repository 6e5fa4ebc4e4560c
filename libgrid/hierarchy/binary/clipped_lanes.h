// Boxes whose planes lie side by side: min and max of all axes take an instruction. And primitives cut by
// planes, with the same bits as by sides_with_margin() (fragment_split.h). Host only.
#pragma once

#include "libgrid/hierarchy/binary/fragment_split.h"
#ifdef MASU_HOST_AVX2
#include "libscene/geometry/lanes.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace masu {

// x, y, z, and a lane that boxes ignore.
using Lanes4 = float __attribute__((vector_size(16)));
using WholeLanes4 = std::int32_t __attribute__((vector_size(16)));
using Lanes8 = float __attribute__((vector_size(32)));
using WholeLanes8 = std::int32_t __attribute__((vector_size(32)));
using BitLanes8 = std::uint32_t __attribute__((vector_size(32)));

inline Lanes4 smaller(Lanes4 a, Lanes4 b) {
  return a < b ? a : b;
}
inline Lanes4 larger(Lanes4 a, Lanes4 b) {
  return a > b ? a : b;
}

struct LaneBox {
  Lanes4 low = {INFINITY, INFINITY, INFINITY, INFINITY};
  Lanes4 high = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

  void join(const LaneBox& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  Lanes4 twice_the_centre() const { return low + high; }
};

// Boxes joined, and numbers of what begins and ends with them: upper planes are negated, so that it takes one
// minimum to join another box, and the numbers are in the lanes that planes leave.
struct CountedBox {
  Lanes8 planes = {INFINITY, INFINITY, INFINITY, 0, INFINITY, INFINITY, INFINITY, 0};

  CountedBox() = default;
  // The numbers are in all lanes.
  explicit CountedBox(const LaneBox& box, WholeLanes4 begin = WholeLanes4{},
                      WholeLanes4 end = WholeLanes4{}) {
    set(__builtin_shufflevector(box.low, -box.high, 0, 1, 2, 3, 4, 5, 6, 7),
        __builtin_shufflevector(begin, end, 0, 1, 2, 3, 4, 5, 6, 7));
  }
  void join(const CountedBox& other) {
    // Of all lanes: without a sign, for the sums of planes mean nothing.
    set(planes < other.planes ? planes : other.planes,
        reinterpret_cast<WholeLanes8>(reinterpret_cast<BitLanes8>(planes) +
                                      reinterpret_cast<BitLanes8>(other.planes)));
  }
  LaneBox box() const {
    return {__builtin_shufflevector(planes, planes, 0, 1, 2, 3),
            -__builtin_shufflevector(planes, planes, 4, 5, 6, 7)};
  }

private:
  void set(const Lanes8& boxes, const WholeLanes8& numbers) {
    planes = __builtin_shufflevector(boxes, reinterpret_cast<Lanes8>(numbers), 0, 1, 2, 11, 4, 5, 6, 15);
  }
};

// A counted box in each lane.
struct CountedLanes {
  Lanes8 planes[3]; // the upper ones come after the lower ones, negated
  WholeLanes8 numbers{};

  CountedLanes() { std::fill_n(planes, 3, Lanes8{} + INFINITY); }
  // Of three; what is in the last lanes is ignored.
  CountedLanes(const CountedBox& a, const CountedBox& b, const CountedBox& c) {
    const auto first = __builtin_shufflevector(a.planes, b.planes, 0, 8, 1, 9, 4, 12, 5, 13),
               last = __builtin_shufflevector(a.planes, b.planes, 2, 10, 3, 11, 6, 14, 7, 15);
    planes[0] = __builtin_shufflevector(first, c.planes, 0, 1, 8, 8, 4, 5, 12, 12);
    planes[1] = __builtin_shufflevector(first, c.planes, 2, 3, 9, 9, 6, 7, 13, 13);
    planes[2] = __builtin_shufflevector(last, c.planes, 0, 1, 10, 10, 4, 5, 14, 14);
    numbers =
        reinterpret_cast<WholeLanes8>(__builtin_shufflevector(last, c.planes, 2, 3, 11, 11, 6, 7, 15, 15));
  }
  void join(const CountedLanes& other) {
    for (int axis = 0; axis < 3; ++axis)
      planes[axis] = planes[axis] < other.planes[axis] ? planes[axis] : other.planes[axis];
    numbers += other.numbers;
  }
  WholeLanes4 begin() const { return __builtin_shufflevector(numbers, numbers, 0, 1, 2, 3); }
  WholeLanes4 end() const { return __builtin_shufflevector(numbers, numbers, 4, 5, 6, 7); }
  Lanes4 low(int axis) const { return __builtin_shufflevector(planes[axis], planes[axis], 0, 1, 2, 3); }
  Lanes4 high(int axis) const { return -__builtin_shufflevector(planes[axis], planes[axis], 4, 5, 6, 7); }
  Lanes4 areas() const {
    const Lanes4 x = high(0) - low(0), y = high(1) - low(1), z = high(2) - low(2);
    return x * (y + z) + y * z;
  }
  // The same; 0 of a box that holds nothing.
  Lanes4 areas_or_0() const {
    return (low(0) <= high(0)) & (low(1) <= high(1)) & (low(2) <= high(2)) ? areas() : Lanes4{};
  }
};

struct LaneSides {
  LaneBox below, above;
};

#ifdef MASU_HOST_AVX2
inline Doubles4 in_lanes(double x, double y, double z) {
  return _mm256_setr_pd(x, y, z, 0);
}
inline LaneBox lanes_around(Doubles4 low, Doubles4 high, double margin) {
  const __m256 both = rounded_up(margin - low, high + margin).v;
  return {-_mm256_castps256_ps128(both), _mm256_extractf128_ps(both, 1)};
}
#endif

// box_around() (node_boxes.h)
inline LaneBox lanes_around(const Boxd& bounds, double margin) {
#ifdef MASU_HOST_AVX2
  return lanes_around(in_lanes(bounds.min.x, bounds.min.y, bounds.min.z),
                      in_lanes(bounds.max.x, bounds.max.y, bounds.max.z), margin);
#else
  const Boxf box = box_around(bounds, margin);
  return {Lanes4{box.min.x, box.min.y, box.min.z, 0}, Lanes4{box.max.x, box.max.y, box.max.z, 0}};
#endif
}

template <class Primitive>
class ClippedLanes {
public:
  explicit ClippedLanes(const Primitive& primitive) : primitive_(primitive) {}

  LaneSides sides(int axis, double plane, double margin) const {
    const ClippedBounds of = sides_of(primitive_, axis, plane, plane);
    const auto part = [&](const Boxd& bounds) {
      return is_empty(bounds) ? LaneBox() : lanes_around(bounds, margin);
    };
    return {part(of.below), part(of.above)};
  }

private:
  // What is computed once for all planes: nothing but for cones.
  std::conditional_t<std::is_same_v<Primitive, Cone<double>>, ClippedCone, const Primitive&> primitive_;
};

#ifdef MASU_HOST_AVX2
// A triangle's coordinates are lanes.
template <>
class ClippedLanes<Triangle<double>> {
public:
  explicit ClippedLanes(const Triangle<double>& t)
      : corners_{in_lanes(t.a.x, t.a.y, t.a.z), in_lanes(t.b.x, t.b.y, t.b.z), in_lanes(t.c.x, t.c.y, t.c.z)},
        along_{in_lanes(t.a.x, t.b.x, t.c.x), in_lanes(t.a.y, t.b.y, t.c.y), in_lanes(t.a.z, t.b.z, t.c.z)} {
    for (unsigned corners = 1; corners < 8; ++corners) {
      of_corners_[corners] = of_corners_[corners & (corners - 1)];
      of_corners_[corners].add(corners_[__builtin_ctz(corners)]);
    }
  }

  LaneSides sides(int axis, double plane, double margin) const {
    const Doubles4 at = plane, begin = along_[axis], end = _mm256_permute4x64_pd(begin.v, 0b11'00'10'01),
                   share = (at - begin) / (end - begin);
    const LaneMask<double> crosses = ((begin < at) & (at < end)) | ((end < at) & (at < begin));
    const LaneMask<double> is_axis(
        _mm256_cmpeq_epi64(_mm256_setr_epi64x(0, 1, 2, 3), _mm256_set1_epi64x(axis)));
    // Of an edge that crosses, where it meets the plane; else NaN, which no bounds take.
    const Doubles4 met = select(crosses, share, std::numeric_limits<double>::quiet_NaN());
    Bounds meetings;
    const auto add = [&](int i, Doubles4 of_edge) {
      const Doubles4 p = corners_[i], edge = corners_[(i + 1) % 3] - p;
      meetings.add(select(is_axis, at, p) + select(is_axis, 0.0, edge) * of_edge);
    };
    add(0, _mm256_permute4x64_pd(met.v, 0x00));
    add(1, _mm256_permute4x64_pd(met.v, 0x55));
    add(2, _mm256_permute4x64_pd(met.v, 0xaa));
    return {meetings.with(of_corners_[(begin <= at).bits() & 7], margin),
            meetings.with(of_corners_[(at <= begin).bits() & 7], margin)};
  }

private:
  struct Bounds {
    Doubles4 low = RealTraits<double>::largest, high = -RealTraits<double>::largest;

    void add(Doubles4 point) {
      low = min(point, low);
      high = max(point, high);
    }
    LaneBox with(const Bounds& other, double margin) const {
      return lanes_around(min(low, other.low), max(high, other.high), margin);
    }
  };

  Doubles4 corners_[3], along_[3]; // along an axis, the corners'
  Bounds of_corners_[8];           // by a bit for each
};
#endif

} // namespace masu
