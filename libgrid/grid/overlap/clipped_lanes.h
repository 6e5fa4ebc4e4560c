// Triangles cut by four planes at once (clipped_bounds.h), on a processor with AVX2. Host only.
#pragma once

#include "libgrid/grid/overlap/clipped_bounds.h"
#include "libscene/geometry/lanes.h"

namespace masu {

// Which axis a lane's plane is across.
class LaneAxes {
public:
  explicit LaneAxes(const int (&axes)[4])
      : axes_{axes[0], axes[1], axes[2], axes[3]},
        lanes_(_mm256_setr_epi64x(axes[0], axes[1], axes[2], axes[3])) {}

  MASU_ALWAYS_INLINE friend Doubles4 coordinate(const Vec3d& v, const LaneAxes& axes) {
    const double all[] = {v.x, v.y, v.z};
    return _mm256_setr_pd(all[axes.axes_[0]], all[axes.axes_[1]], all[axes.axes_[2]], all[axes.axes_[3]]);
  }
  MASU_ALWAYS_INLINE friend void set_coordinate(Vec3<Doubles4>& v, const LaneAxes& axes, Doubles4 to) {
    const auto is = [&](long long axis) {
      return LaneMask<double>(_mm256_cmpeq_epi64(axes.lanes_, _mm256_set1_epi64x(axis)));
    };
    v = {select(is(0), to, v.x), select(is(1), to, v.y), select(is(2), to, v.z)};
  }

private:
  int axes_[4];
  __m256i lanes_;
};

template <class Point>
MASU_ALWAYS_INLINE void join_where(LaneMask<double> is_there, Box<Doubles4>& box, const Point& point) {
  const Vec3<Doubles4> p = point();
  const Doubles4 far = RealTraits<double>::largest;
  const auto add = [&](Doubles4 at, Doubles4& low, Doubles4& high) {
    low = min(low, select(is_there, at, far));
    high = max(high, select(is_there, at, -far));
  };
  add(p.x, box.min.x, box.max.x);
  add(p.y, box.min.y, box.max.y);
  add(p.z, box.min.z, box.max.z);
}

} // namespace masu
