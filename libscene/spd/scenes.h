// What the scenes are made of: rotations and coordinate frames, and buffered output of NFF text. A line of
// that is a keyword and numbers, which have six significant digits.
#pragma once

#include "libscene/geometry/vector.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string>

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

struct NffWriter {
  std::FILE* out;
  std::string place;                                     // names `out` in errors
  std::string text{};                                    // buffer; bounded
  std::uint64_t objects = 0;                             // written so far
  std::function<void(std::uint64_t objects)> progress{}; // called now and then, where there is one
};

// The view; the defaults are those of most scenes.
struct View {
  Vec3d from{}, at{}, up{};
  double hither = 1; // near plane
  Vec3d background = {0.078, 0.361, 0.753};
  double angle = 45;    // field of view in degrees
  int resolution = 512; // pixels along each side
};

struct Material {
  double red, green, blue;
  double diffuse, specular, shine;
  double transmittance, index_of_refraction;
};

// A corner with its unit normal.
struct Corner {
  Vec3d position, normal;
};

// All of these throw Error(output) when the file can't be written.
void put_view(NffWriter& nff, const View& view);
void put_lights(NffWriter& nff, std::initializer_list<Vec3d> positions);
void put_material(NffWriter& nff, const Material& material);
void put_sphere(NffWriter& nff, const Vec3d& center, double radius);
void put_cone(NffWriter& nff, const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius);
void put_polygon(NffWriter& nff, std::span<const Vec3d> corners);
void put_polygon(NffWriter& nff, std::initializer_list<Vec3d> corners);
void put_triangle(NffWriter& nff, const Corner& a, const Corner& b, const Corner& c);

// Writes the rest of the buffer and flushes the file.
void finish(NffWriter& nff);

// One for each scene; spd.cpp checks the size first.
void write_balls(NffWriter& nff, int size, bool background);
void write_gears(NffWriter& nff, int size, bool background);
void write_mount(NffWriter& nff, int size, bool background);
void write_nurbs(NffWriter& nff, int size, bool background);
void write_rings(NffWriter& nff, int size, bool background);
void write_teapot(NffWriter& nff, int size, bool background);
void write_tetra(NffWriter& nff, int size, bool background);
void write_tree(NffWriter& nff, int size, bool background);

} // namespace masu::spd
