// The point of a primitive's surface that is closest to a place, in double: off by some roundings of the
// largest coordinate, which is up to 1e37. After Ericson, "Real-Time Collision Detection", Morgan Kaufmann
// 2005, chapter 5.1.
#pragma once

#include "libscene/geometry/primitives.h"

#include <cmath>

namespace masu {

struct ClosestPoint {
  double squared = INFINITY; // of the distance
  Vec3d point{0, 0, 0};
  Vec3d normal{0, 0, 0};             // on the front, of any length; zero of a triangle without area
  double weight_b = 0, weight_c = 0; // of a triangle: barycentric coordinates
};

// Of a vector whose square isn't rounded to a denormal number: a shorter one has no direction.
inline constexpr double least_length = 0x1p-500;

// Where from p to q a point is closest to `place`: 0 at p, 1 at q. Swapping p and q gives the same point, so
// that triangles which share an edge are equally far.
MASU_HD inline double closest_along(const Vec3d& p, const Vec3d& q, const Vec3d& place, Vec3d& point) {
  const bool swapped = q.x < p.x || (q.x == p.x && (q.y < p.y || (q.y == p.y && q.z < p.z)));
  const Vec3d& from = swapped ? q : p;
  const Vec3d& to = swapped ? p : q;
  const Vec3d along = to - from;
  const double length = dot(along, along), at = dot(place - from, along);
  const double share = at > 0 ? (at < length ? at / length : 1) : 0;
  point = share == 1 ? to : from + along * share;
  return swapped ? 1 - share : share;
}

MASU_HD inline ClosestPoint closest_point(const Triangle<double>& triangle, const Vec3d& place) {
  ClosestPoint closest;
  const auto candidate = [&](const Vec3d& point, double b, double c) {
    const Vec3d away = place - point;
    const double squared = dot(away, away);
    if (squared < closest.squared) closest = {squared, point, {0, 0, 0}, b, c};
  };
  const Vec3d &a = triangle.a, &b = triangle.b, &c = triangle.c;
  const Vec3d normal = cross(b - a, c - a);
  const double area = dot(normal, normal);
  // Whether the place's projection is on the triangle's side of the edge from p to q, by more than roundings:
  // less isn't worth more than a point of the edge. `weight`: of the corner that is across, times `area`.
  const auto is_within = [&](const Vec3d& p, const Vec3d& q, double& weight) {
    const Vec3d edge = q - p, from = place - p;
    weight = dot(normal, cross(edge, from));
    return weight > 0 && weight * weight > 0x1p-98 * area * dot(edge, edge) * dot(from, from);
  };
  double weight_a = 0, weight_b = 0, weight_c = 0;
  if (is_within(b, c, weight_a) && is_within(c, a, weight_b) && is_within(a, b, weight_c)) {
    candidate(place - normal * (dot(normal, place - a) / area), weight_b / area, weight_c / area);
  } else {
    Vec3d point{};
    double share = closest_along(a, b, place, point);
    candidate(point, share, 0);
    share = closest_along(b, c, place, point);
    candidate(point, 1 - share, share);
    share = closest_along(c, a, place, point);
    candidate(point, 0, 1 - share);
  }
  closest.normal = normal;
  return closest;
}

MASU_HD inline ClosestPoint closest_point(const Sphere<double>& sphere, const Vec3d& place) {
  const Vec3d away = place - sphere.center;
  const double distance = std::sqrt(dot(away, away)), radius = std::abs(sphere.radius),
               off = distance - radius;
  // Any from the centre.
  const Vec3d outward = distance > least_length ? away * (1 / distance) : Vec3d{1, 0, 0};
  return {off * off, sphere.center + outward * radius, outward * (sphere.radius < 0 ? -1.0 : 1.0)};
}

// In the plane through the axis and the place, where the side is a segment.
MASU_HD inline ClosestPoint closest_point(const Cone<double>& cone, const Vec3d& place) {
  const Vec3d axis = cone.apex - cone.base, from_base = place - cone.base;
  const double height = std::sqrt(dot(axis, axis));
  const Vec3d up = axis * (1 / height);
  const double along = dot(from_base, up);
  const Vec3d rounded = from_base - up * along;
  const Vec3d across = rounded - up * dot(rounded, up); // near the axis, roundings along it have been left
  const double distance = std::sqrt(dot(across, across));
  // Where most of `rounded` was along the axis, roundings are all there is, and what is left isn't across it.
  const bool is_off_axis = distance > least_length && 4 * dot(across, across) > dot(rounded, rounded);
  // From the axis any direction across it will do: that of the coordinate axis that is farthest from it.
  const Vec3d least = std::abs(up.x) <= std::abs(up.y) && std::abs(up.x) <= std::abs(up.z) ? Vec3d{1, 0, 0}
                      : std::abs(up.y) <= std::abs(up.z)                                   ? Vec3d{0, 1, 0}
                                                                                           : Vec3d{0, 0, 1};
  const Vec3d any = cross(up, least);
  const Vec3d outward = is_off_axis ? across * (1 / distance) : any * (1 / std::sqrt(dot(any, any)));
  const double base = std::abs(cone.base_radius), taper = std::abs(cone.apex_radius) - base;
  const double at = along * height + (distance - base) * taper, length = height * height + taper * taper;
  const double share = at > 0 ? (at < length ? at / length : 1) : 0;
  const double off_along = along - share * height, radius = base + share * taper,
               off_across = distance - radius;
  const bool inside_out = cone.base_radius < 0 || cone.apex_radius < 0;
  return {off_along * off_along + off_across * off_across,
          cone.base + up * (share * height) + outward * radius,
          (outward * height - up * taper) * (inside_out ? -1.0 : 1.0)};
}

} // namespace masu
