// Rotations and coordinate frames for the scenes.
#pragma once

#include "libscene/geometry/vector.h"

#include <numbers>

namespace masu::spd {

inline constexpr Vec3d x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

constexpr double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

// v rotated about a unit axis by an angle in radians, counter-clockwise seen from the axis' tip (Rodrigues'
// formula).
inline Vec3d rotated(const Vec3d& v, const Vec3d& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

// Three axes; not necessarily of unit length.
struct Frame {
  Vec3d x, y, z;
};

// v, given in the frame's coordinates, in the coordinates of its axes.
inline Vec3d from_frame(const Frame& frame, const Vec3d& v) {
  return frame.x * v.x + frame.y * v.y + frame.z * v.z;
}

} // namespace masu::spd
