// Primitives cut by planes, with the same bits as by sides_with_margin() (fragment_split.h). Host only.
#pragma once

#include "libgrid/hierarchy/binary/fragment_split.h"
#include "libgrid/hierarchy/binary/lane_box.h"
#ifdef MASU_HOST_AVX2
#include "libscene/geometry/lanes.h"
#endif

#include <limits>
#include <utility>

namespace masu {

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

// What is computed once for all planes: nothing but for cones.
template <class Primitive>
const Primitive& prepared_to_clip(const Primitive& primitive) {
  return primitive;
}
inline ClippedCone prepared_to_clip(const Cone<double>& cone) {
  return ClippedCone(cone);
}

template <class Primitive>
class ClippedLanes {
public:
  explicit ClippedLanes(const Primitive& primitive) : primitive_(prepared_to_clip(primitive)) {}

  LaneSides sides(int axis, double plane, double margin) const {
    const ClippedBounds of = sides_of(primitive_, axis, plane, plane);
    const auto part = [&](const Boxd& bounds) {
      return is_empty(bounds) ? LaneBox() : lanes_around(bounds, margin);
    };
    return {part(of.below), part(of.above)};
  }

private:
  decltype(prepared_to_clip(std::declval<const Primitive&>())) primitive_;
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
