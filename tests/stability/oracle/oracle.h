// Reference intersection in 113-bit arithmetic, with none of the tracer's formulas.
//
// Coordinates are doubles at most (53 bits), so the rounding errors here are 2⁻⁶⁰ of theirs. Results are
// certain except within the tracer's documented error bound of an edge, a silhouette or a rim, where they are
// `unsure`. The type is built into GCC and Clang (__float128 on x86, long double elsewhere). Exact rationals
// would gain nothing: square roots aren't rational.
#pragma once

#include "libscene/geometry/primitives.h"

#include <array>
#include <cmath>
#include <limits>

namespace masu::oracle {

#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;
static_assert(std::numeric_limits<long double>::digits >= 113);
#endif

// --- Points ---------------------------------------------------------------------------------------------

struct Point {
  Wide x, y, z;
};

template <class T>
Point point(const Vec3<T>& v) {
  return {static_cast<Wide>(v.x), static_cast<Wide>(v.y), static_cast<Wide>(v.z)};
}
inline Point operator+(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point operator*(const Point& a, Wide s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Wide inner(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point outer(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Wide magnitude(Wide v) {
  return v < 0 ? -v : v;
}
inline Wide min(Wide a, Wide b) {
  return a < b ? a : b;
}
inline Wide max(Wide a, Wide b) {
  return a > b ? a : b;
}

// Newton's iteration from the square root in double; 0 for arguments that aren't positive.
inline Wide root(Wide v) {
  if (!(v > 0)) return 0;
  constexpr double far = 1e250, unit = 0x1p400;
  if (v < 1 / far) return root(v * unit * unit) / unit;
  if (v > far) return root(v / unit / unit) * unit;
  Wide r = std::sqrt(static_cast<double>(v));
  for (int i = 0; i < 3; ++i)
    r = (r + v / r) / 2;
  return r;
}
inline Wide norm(const Point& a) {
  return root(inner(a, a));
}

struct Line {
  Point origin, direction;
  Point at(Wide t) const { return origin + direction * t; }
};

template <class T>
Line line(const Vec3<T>& origin, const Vec3<T>& direction) {
  return {point(origin), point(direction)};
}

// --- Distance of a point from a surface -----------------------------------------------------------------

inline Wide distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a, from = p - a;
  const Wide square = inner(along, along), share = inner(from, along);
  if (!(share > 0)) return norm(from);
  if (share >= square) return norm(p - b);
  return norm(from - along * (share / square));
}

template <class T>
Wide distance(const Point& p, const Triangle<T>& triangle) {
  const std::array corners{point(triangle.a), point(triangle.b), point(triangle.c)};
  const Point normal = outer(corners[1] - corners[0], corners[2] - corners[0]);
  Wide nearest = distance_to_segment(p, corners[0], corners[1]);
  bool inside = inner(normal, normal) > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % 3];
    nearest = min(nearest, distance_to_segment(p, a, b));
    inside = inside && inner(outer(b - a, p - a), normal) >= 0;
  }
  return inside ? magnitude(inner(p - corners[0], normal)) / norm(normal) : nearest;
}

template <class T>
Wide distance(const Point& p, const Sphere<T>& sphere) {
  return magnitude(norm(p - point(sphere.center)) - magnitude(static_cast<Wide>(sphere.radius)));
}

// A cone in cylindrical coordinates about its axis: a segment of heights 0 to `length`, with radius
// base_radius + slope * height.
struct Profile {
  Point base, up;
  Wide length, base_radius, slope;

  Wide height(const Point& p) const { return inner(p - base, up); }
  Wide off_axis(const Point& p) const { return norm(p - base - up * height(p)); }
};

template <class T>
Profile profile(const Cone<T>& cone) {
  const Point axis = point(cone.apex) - point(cone.base);
  const Wide length = norm(axis);
  const Wide base_radius = magnitude(static_cast<Wide>(cone.base_radius));
  const Wide growth = magnitude(static_cast<Wide>(cone.apex_radius)) - base_radius;
  return {point(cone.base), axis * (1 / length), length, base_radius, growth / length};
}

template <class T>
Wide distance(const Point& p, const Cone<T>& cone) {
  const Profile side = profile(cone);
  return distance_to_segment({side.off_axis(p), side.height(p), 0}, {side.base_radius, 0, 0},
                             {side.base_radius + side.slope * side.length, side.length, 0});
}

// --- Intersection with a ray ----------------------------------------------------------------------------

enum class Result { miss, hit, unsure };

// The first hit with t > 0. It lies between `low` and `high`, the extremes over surfaces displaced by the
// slack.
struct Expected {
  Result result;
  Wide low, high;
};

// `slack`: the bound on the tracer's error, as a displacement of the primitive.
template <class T>
Expected expect(const Line& ray, const Triangle<T>& triangle, Wide slack) {
  const Wide square = inner(ray.direction, ray.direction), length = root(square);
  const std::array corners{point(triangle.a) - ray.origin, point(triangle.b) - ray.origin,
                           point(triangle.c) - ray.origin};
  // Projected along the ray, which becomes the point 0.
  std::array<Point, 3> seen{};
  for (std::size_t i = 0; i < 3; ++i)
    seen[i] = corners[i] - ray.direction * (inner(corners[i], ray.direction) / square);
  bool left = true, right = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = seen[i], &b = seen[(i + 1) % 3];
    if (distance_to_segment({0, 0, 0}, a, b) <= slack) return {Result::unsure, 0, 0};
    const Wide side = inner(ray.direction, outer(a, b));
    // A ray inside the triangle is farther than the slack from the edges' lines, too. Without that, roundings
    // decide where the ray lies in the triangle's plane: all three sides are 0 then.
    const Wide least = slack * norm(b - a) * length / 2;
    left = left && side > least;
    right = right && side < -least;
  }
  if (!left && !right) return {Result::miss, 0, 0};
  const Point normal = outer(corners[1] - corners[0], corners[2] - corners[0]);
  const Wide facing = inner(normal, ray.direction);
  const Wide t = inner(normal, corners[0]) / facing, by = slack * norm(normal) / magnitude(facing);
  if (t + by <= 0) return {Result::miss, 0, 0};
  if (t - by <= 0) return {Result::unsure, 0, 0};
  return {Result::hit, t - by, t + by};
}

// Up to two intersections of a line with a surface; `leaving`: from the inside to the outside.
struct Crossing {
  Wide t;
  bool leaving;
};
struct Crossings {
  std::array<Crossing, 2> at{};
  int count = 0;
  bool comes_inside = false; // the line is inside the cone where it enters the slab between the ends
  bool unsure = false;
};

// Roots of a t² + 2 b t + c, which rises where the line leaves. Unsure near a double root, such as at a
// cone's apex.
inline Crossings solve(Wide a, Wide b, Wide c) {
  Crossings found;
  const Wide discriminant = b * b - a * c;
  found.unsure = magnitude(discriminant) <= 1e-24 * b * b;
  if (discriminant < 0) return found;
  const Wide q = -(b + (b < 0 ? -root(discriminant) : root(discriminant)));
  if (q == 0) {
    found.unsure = true;
    if (a != 0) found.at[static_cast<std::size_t>(found.count++)] = {0, true};
    return found;
  }
  for (const Wide t : {a == 0 ? c / q : q / a, c / q}) {
    found.at[static_cast<std::size_t>(found.count++)] = {t, a * t + b > 0};
    if (a == 0) break;
  }
  if (found.count == 2 && found.at[1].t < found.at[0].t) std::swap(found.at[0], found.at[1]);
  return found;
}

// The sphere with its radius changed by `by`.
template <class T>
Crossings cross(const Line& ray, const Sphere<T>& sphere, Wide by) {
  const Wide radius = magnitude(static_cast<Wide>(sphere.radius)) + by;
  if (radius <= 0) return {};
  const Wide square = inner(ray.direction, ray.direction);
  const Point to_center = point(sphere.center) - ray.origin;
  const Wide nearest = inner(to_center, ray.direction) / square;
  const Point off = to_center - ray.direction * nearest;
  Crossings found;
  const Wide rest = radius * radius - inner(off, off);
  if (rest < 0) return found;
  const Wide half_chord = root(rest / square);
  found.at = {Crossing{nearest - half_chord, false}, Crossing{nearest + half_chord, true}};
  found.count = 2;
  return found;
}

// The cone with its side displaced outwards by `by` and its ends by `beyond`; unsure near a pointed end.
template <class T>
Crossings cross(const Line& ray, const Cone<T>& cone, Wide by, Wide beyond) {
  Profile side = profile(cone);
  side.base_radius += by * root(1 + side.slope * side.slope);
  const Wide rise = inner(ray.direction, side.up), height = side.height(ray.origin);
  const Point across = ray.direction - side.up * rise;
  const Point off = ray.origin - side.base - side.up * height;
  const Wide radius = side.base_radius + side.slope * height, slope = side.slope * rise;
  const Wide a = inner(across, across) - slope * slope, b = inner(off, across) - slope * radius,
             c = inner(off, off) - radius * radius;
  const Crossings all = solve(a, b, c);
  Crossings found;
  found.unsure = all.unsure;
  if (rise != 0) {
    const Wide comes = ((rise > 0 ? -beyond : side.length + beyond) - height) / rise;
    found.comes_inside = (a * comes + 2 * b) * comes + c < 0 && radius + slope * comes > 0;
  }
  for (int i = 0; i < all.count; ++i) {
    const Crossing& crossing = all.at[static_cast<std::size_t>(i)];
    const Wide at = height + rise * crossing.t;
    if (at < -beyond || at > side.length + beyond) continue;
    if (side.base_radius + side.slope * at <= magnitude(by) * root(1 + side.slope * side.slope))
      found.unsure = true;
    found.at[static_cast<std::size_t>(found.count++)] = crossing;
  }
  return found;
}

// The index of the first visible crossing with t > after; -1 for none.
inline int first_seen(const Crossings& crossings, bool inside_only, Wide after) {
  for (int i = 0; i < crossings.count; ++i) {
    const Crossing& crossing = crossings.at[static_cast<std::size_t>(i)];
    if (crossing.t > after && (crossing.leaving || !inside_only)) return i;
  }
  return -1;
}

// The result is sure where all displaced versions of the surface agree.
template <std::size_t n>
Expected agreed(const Line& ray, const std::array<Crossings, n>& versions, bool inside_only, Wide slack) {
  const Wide step = slack / norm(ray.direction);
  const int seen = first_seen(versions[0], inside_only, 0);
  Expected expected{seen < 0 ? Result::miss : Result::hit, 0, 0};
  bool first = true;
  for (const Crossings& version : versions) {
    if (version.unsure || version.count != versions[0].count ||
        version.comes_inside != versions[0].comes_inside || first_seen(version, inside_only, -step) != seen ||
        first_seen(version, inside_only, step) != seen)
      return {Result::unsure, 0, 0};
    if (seen < 0) continue;
    const Crossing& crossing = version.at[static_cast<std::size_t>(seen)];
    if (crossing.leaving != versions[0].at[static_cast<std::size_t>(seen)].leaving)
      return {Result::unsure, 0, 0};
    expected.low = first ? crossing.t - step : min(expected.low, crossing.t - step);
    expected.high = first ? crossing.t + step : max(expected.high, crossing.t + step);
    first = false;
  }
  return expected;
}

template <class T>
Expected expect(const Line& ray, const Sphere<T>& sphere, Wide slack) {
  const std::array versions{cross(ray, sphere, 0), cross(ray, sphere, slack), cross(ray, sphere, -slack)};
  return agreed(ray, versions, sphere.radius < 0, slack);
}

template <class T>
Expected expect(const Line& ray, const Cone<T>& cone, Wide slack) {
  const std::array versions{cross(ray, cone, 0, 0), cross(ray, cone, slack, slack),
                            cross(ray, cone, slack, -slack), cross(ray, cone, -slack, slack),
                            cross(ray, cone, -slack, -slack)};
  return agreed(ray, versions, cone.base_radius < 0 || cone.apex_radius < 0, slack);
}

} // namespace masu::oracle
