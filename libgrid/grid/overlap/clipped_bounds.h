// Primitives cut by planes across an axis; and how large they are.
#pragma once

#include "libscene/geometry/cone.h"
#include "libscene/geometry/primitives.h"

#include <algorithm>

namespace masu {

// The parts of a primitive on either side of a plane: bounds of what is at most `low` along the axis, and of
// what is at least `high`.
struct ClippedBounds {
  Boxd below, above;
};

MASU_HD inline ClippedBounds sides_of(const Triangle<double>& triangle, int axis, double low, double high) {
  const Vec3d corners[] = {triangle.a, triangle.b, triangle.c};
  ClippedBounds sides{empty_box<double>(), empty_box<double>()};
  for (int i = 0; i < 3; ++i) {
    const Vec3d &p = corners[i], &q = corners[(i + 1) % 3];
    const double begin = p[axis], end = q[axis];
    if (begin <= low) sides.below = join(sides.below, p);
    if (high <= begin) sides.above = join(sides.above, p);
    const auto join_meeting = [&](double plane, Boxd& box) {
      if (!(begin < plane && plane < end) && !(end < plane && plane < begin)) return;
      Vec3d at = p + (q - p) * ((plane - begin) / (end - begin));
      at.set(axis, plane);
      box = join(box, at);
    };
    join_meeting(low, sides.below);
    join_meeting(high, sides.above);
  }
  return sides;
}

MASU_HD inline ClippedBounds sides_of(const Sphere<double>& sphere, int axis, double low, double high) {
  const Boxd whole = bounds(sphere);
  ClippedBounds sides{whole, whole};
  const auto cut = [&](Boxd& box, double plane, bool below) {
    const double off = plane - sphere.center[axis], radius = std::abs(sphere.radius);
    if (below ? off < -radius : off > radius) {
      box = empty_box<double>();
      return;
    }
    // The plane's circle is the widest place of what is cut off short of the middle.
    if (below ? off < 0 : off > 0) {
      const double across = std::sqrt(std::max(0.0, radius * radius - off * off));
      box = grown(Boxd{sphere.center, sphere.center}, across);
      box.min.set(axis, whole.min[axis]);
      box.max.set(axis, whole.max[axis]);
    }
    (below ? box.max : box.min).set(axis, std::clamp(plane, whole.min[axis], whole.max[axis]));
  };
  cut(sides.below, low, true);
  cut(sides.above, high, false);
  return sides;
}

// A cone, and what bounds of all of its parts take.
struct ClippedCone {
  Vec3d middle, along, reach; // middle: the base's
  double base_radius, apex_radius;
  Boxd base, apex;
  double slack; // more than what the discs' places along an axis are rounded by

  MASU_HD ClippedCone(const Cone<double>& cone)
      : middle(cone.base), along(cone.apex - cone.base), reach(disc_reach(along)),
        base_radius(std::abs(cone.base_radius)), apex_radius(std::abs(cone.apex_radius)),
        base(disc_bounds(cone.base, base_radius, reach)), apex(disc_bounds(cone.apex, apex_radius, reach)),
        slack(0x1p-49 * largest_magnitude(join(base, apex))) {}
};
MASU_HD inline ClippedBounds sides_of(const ClippedCone& cone, int axis, double low, double high) {
  // The bounds of the discs that reach a plane's side, from how far beyond the plane those of base and apex
  // are (what reaches it: zero or less); in between that changes evenly along the axis.
  const auto reaching = [&](double from_base, double from_apex) {
    if (from_base > 0 && from_apex > 0) return empty_box<double>();
    const auto disc = [&](double share) {
      return disc_bounds(cone.middle + cone.along * share,
                         cone.base_radius + (cone.apex_radius - cone.base_radius) * share, cone.reach);
    };
    const double share = from_base / (from_base - from_apex); // of the axis, where a disc just does
    return join(from_base > 0 ? disc(share) : cone.base, from_apex > 0 ? disc(share) : cone.apex);
  };
  const double slack = cone.slack;
  ClippedBounds sides{reaching(cone.base.min[axis] - slack - low, cone.apex.min[axis] - slack - low),
                      reaching(high - slack - cone.base.max[axis], high - slack - cone.apex.max[axis])};
  sides.below.max.set(axis, std::min(sides.below.max[axis], low));
  sides.above.min.set(axis, std::max(sides.above.min[axis], high));
  return sides;
}

// The side of a square as large as what is seen of the primitive from where it is seen best.
MASU_HD inline double breadth(const Triangle<double>& triangle) {
  return std::sqrt(length(cross(triangle.b - triangle.a, triangle.c - triangle.a)) / 2);
}
MASU_HD inline double breadth(const Sphere<double>& sphere) {
  return 2 * std::abs(sphere.radius);
}
MASU_HD inline double breadth(const Cone<double>& cone) {
  return std::sqrt(length(cone.apex - cone.base) * (std::abs(cone.base_radius) + std::abs(cone.apex_radius)));
}

} // namespace masu
