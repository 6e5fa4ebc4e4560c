#include "libscene/plane_cut.h"

#include "libscene/geometry/cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace masu {
namespace {

constexpr double pi = std::numbers::pi;

// So many chords of a full turn that none is farther from a circle of this radius than `deviation`.
int chords_for(double radius, double deviation) {
  constexpr double least = 8, most = 512;
  const double half_angle = std::acos(std::clamp(1 - deviation / radius, -1.0, 1.0));
  return static_cast<int>(std::clamp(std::ceil(pi / std::max(half_angle, 1e-9)), least, most));
}

class Section {
public:
  explicit Section(const PlaneCut& options)
      : options_(options), u_(options.axis == 0 ? 1 : 0),
        v_(options.axis == 2 ? 1 : 2), origin_{options.origin[u_], options.origin[v_]} {
    options_.position -= options.origin[options.axis];
    for (std::size_t i = 0; i < 2; ++i) {
      options_.min[i] -= origin_[i];
      options_.max[i] -= origin_[i];
    }
  }

  template <class Primitive>
  void add(const Primitive& primitive, PrimitiveIndex index) {
    const Boxd box = bounds(primitive);
    const bool is_met = box.min[options_.axis] <= options_.position &&
                        box.max[options_.axis] >= options_.position && box.min[u_] <= options_.max[0] &&
                        box.max[u_] >= options_.min[0] && box.min[v_] <= options_.max[1] &&
                        box.max[v_] >= options_.min[1];
    if (!is_met) return;
    primitive_ = index;
    cut(primitive);
  }

  std::vector<CutSegment> segments;

private:
  using Point = std::array<double, 2>;

  Point in_plane(const Vec3d& p) const { return {p[u_], p[v_]}; }
  void segment(const Point& from, const Point& to) {
    const auto in_world = [&](const Point& p) { return Point{p[0] + origin_[0], p[1] + origin_[1]}; };
    if (from != to) segments.push_back({in_world(from), in_world(to), primitive_});
  }

  void cut(const Triangle<double>& triangle) {
    const std::array<Vec3d, 3> corners{triangle.a, triangle.b, triangle.c};
    std::array<double, 3> above{};
    for (std::size_t i = 0; i < 3; ++i)
      above[i] = corners[i][options_.axis] - options_.position;
    std::array<Point, 3> points{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (above[i] == 0) points[count++] = in_plane(corners[i]);
      if ((above[i] < 0 && above[next] > 0) || (above[i] > 0 && above[next] < 0)) {
        // From the lower corner, so that triangles sharing the edge get the same point.
        const std::size_t low = above[i] < 0 ? i : next, high = above[i] < 0 ? next : i;
        const double share = above[low] / (above[low] - above[high]);
        points[count++] = in_plane(corners[low] + (corners[high] - corners[low]) * share);
      }
    }
    if (count >= 2) segment(points[0], points[1]);
    if (count == 3) { // all corners: one in the plane and two crossed edges can't be
      segment(points[1], points[2]);
      segment(points[2], points[0]);
    }
  }

  void cut(const Sphere<double>& sphere) {
    const double radius = std::abs(sphere.radius), height = options_.position - sphere.center[options_.axis];
    const double square = (radius - height) * (radius + height);
    if (!(square > 0)) return;
    const double circle = std::sqrt(square);
    const Point center = in_plane(sphere.center);
    const int chords = chords_for(circle, options_.deviation);
    Point last{center[0] + circle, center[1]};
    for (int i = 1; i <= chords; ++i) {
      const double angle = 2 * pi * (i % chords) / chords;
      const Point next{center[0] + circle * std::cos(angle), center[1] + circle * std::sin(angle)};
      segment(last, next);
      last = next;
    }
  }

  // The side is base + z·axis + R(z)(cos φ·e + sin φ·f), z from 0 to 1, with R(z) = r + g·z, and e in the
  // direction in which the plane's normal leaves the axis. In the plane, with A the axis' part along the
  // normal, s that of e, and D the plane's height over the base:
  //
  //   z·A + s·R(z)·cos φ = D
  //
  // Where A + g·s·cos φ has no zero, there is one z for each φ; else both φ and -φ of each z are taken.
  void cut(const Cone<double>& cone) {
    const Vec3d axis = cone.apex - cone.base;
    Vec3d normal{0, 0, 0};
    normal.set(options_.axis, 1);
    const double length = std::sqrt(dot(axis, axis));
    const Vec3d along = axis * (1 / length);
    const Vec3d toward = normal - along * along[options_.axis];
    const double s = std::sqrt(dot(toward, toward));
    const Vec3d e = s > 1e-12 ? toward * (1 / s) : any_perpendicular(along);
    const ConePlane plane{cone.base,
                          axis,
                          e,
                          cross(along, e),
                          std::abs(cone.base_radius),
                          std::abs(cone.apex_radius) - std::abs(cone.base_radius),
                          axis[options_.axis],
                          s > 1e-12 ? s : 0,
                          options_.position - cone.base[options_.axis]};
    if (std::abs(plane.A) > 2 * plane.s * std::abs(plane.growth) && std::abs(plane.A) > 1e-3 * length)
      cut_around(plane);
    else
      cut_along(plane);
  }

  struct ConePlane {
    Vec3d base, axis, e, f;
    double radius, growth; // R(z)
    double A, s, D;

    double radius_at(double z) const { return std::max(radius + growth * z, 0.0); }
    // Of the z's point in the plane; beyond ±1 where there is none.
    double cosine_at(double z) const {
      const double reach = s * radius_at(z);
      return reach > 0 ? (D - z * A) / reach : 0;
    }
    Vec3d point(double z, double cosine, double side) const {
      const double sine = side * std::sqrt(std::max((1 - cosine) * (1 + cosine), 0.0));
      return base + axis * z + (e * cosine + f * sine) * radius_at(z);
    }
  };

  static Vec3d any_perpendicular(const Vec3d& direction) {
    Vec3d other{0, 0, 0};
    const int least = std::abs(direction.x) < std::abs(direction.y)
                          ? (std::abs(direction.x) < std::abs(direction.z) ? 0 : 2)
                          : (std::abs(direction.y) < std::abs(direction.z) ? 1 : 2);
    other.set(least, 1);
    return normalized(cross(direction, other));
  }

  int chords_of(const ConePlane& plane) const {
    const double widest = std::max(plane.radius_at(0), plane.radius_at(1));
    return std::max(chords_for(widest, options_.deviation), 32);
  }

  template <class At>
  void both_sides(int chords, const At& at) {
    for (const double side : {1.0, -1.0})
      for (int i = 0; i < chords; ++i)
        segment(at(i, side), at(i + 1, side));
  }

  // z(cos φ) is monotonic, so that 0 ≤ z ≤ 1 holds for an interval of cosines.
  void cut_around(const ConePlane& plane) {
    const auto z_at = [&](double cosine) {
      return (plane.D - plane.radius * plane.s * cosine) / (plane.A + plane.growth * plane.s * cosine);
    };
    double low = -1, high = 1; // cosines
    const double z_low = z_at(low), z_high = z_at(high);
    if (std::max(z_low, z_high) < 0 || std::min(z_low, z_high) > 1) return;
    const auto bound = [&](double z_end, double& cosine) { // the interval ends with the cone
      const double end = std::clamp(z_end, 0.0, 1.0);
      if (z_end != end) cosine = std::clamp(plane.cosine_at(end), -1.0, 1.0);
    };
    bound(z_low, low);
    bound(z_high, high);
    const double from = std::acos(high), to = std::acos(low);
    const int chords = chords_of(plane) / 2;
    both_sides(chords, [&](int chord, double side) {
      const double cosine = chord == 0        ? high
                            : chord == chords ? low
                                              : std::cos(from + (to - from) * chord / chords);
      return in_plane(plane.point(std::clamp(z_at(cosine), 0.0, 1.0), cosine, side));
    });
  }

  // |D - z·A| ≤ s·R(z): two linear inequalities, so that z is in an interval.
  void cut_along(const ConePlane& plane) {
    double low = 0, high = 1;
    const auto limit = [&](double constant, double slope) { // constant + slope·z ≥ 0
      if (slope > 0) low = std::max(low, -constant / slope);
      if (slope < 0) high = std::min(high, -constant / slope);
      if (slope == 0 && constant < 0) high = -1;
    };
    limit(plane.s * plane.radius - plane.D, plane.s * plane.growth + plane.A);
    limit(plane.s * plane.radius + plane.D, plane.s * plane.growth - plane.A);
    if (!(low < high)) return;
    const int chords = chords_of(plane) / 2;
    both_sides(chords, [&](int chord, double side) {
      // Closer together at the ends, where the curve may turn back.
      const double share = (1 - std::cos(pi * chord / chords)) / 2;
      const double z = chord == chords ? high : low + (high - low) * share;
      return in_plane(plane.point(z, std::clamp(plane.cosine_at(z), -1.0, 1.0), side));
    });
  }

  PlaneCut options_; // relative to the origin
  int u_, v_;
  Point origin_;
  PrimitiveIndex primitive_ = no_primitive;
};

} // namespace

template <class Stored>
std::vector<CutSegment> plane_cut_of(const SceneView<Stored>& scene, const PlaneCut& options) {
  Section section(options);
  for (PrimitiveIndex i = 0; i < scene.primitive_count(); ++i)
    with_primitive(scene, i, [&](const auto& primitive) { section.add(primitive, i); });
  return std::move(section.segments);
}
template std::vector<CutSegment> plane_cut_of(const SceneView<float>&, const PlaneCut&);
template std::vector<CutSegment> plane_cut_of(const SceneView<double>&, const PlaneCut&);

} // namespace masu
