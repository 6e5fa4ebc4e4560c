// Buffered output of NFF text. A line is a keyword and numbers, which have six significant digits.
#pragma once

#include "libscene/spd/frame.h"

#include <cstdio>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>

namespace masu::spd {

struct NffWriter {
  NffWriter(std::FILE* out, std::string place);

  std::FILE* out;
  std::string place;                                     // names `out` in errors
  std::string text;                                      // buffer; bounded
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
void put_light(NffWriter& nff, const Vec3d& position);
void put_material(NffWriter& nff, const Material& material);
void put_sphere(NffWriter& nff, const Vec3d& center, double radius);
void put_cone(NffWriter& nff, const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius);
void put_polygon(NffWriter& nff, std::span<const Vec3d> corners);
void put_polygon(NffWriter& nff, std::initializer_list<Vec3d> corners);
void put_triangle(NffWriter& nff, const Corner& a, const Corner& b, const Corner& c);

// Writes the rest of the buffer and flushes the file.
void finish(NffWriter& nff);

} // namespace masu::spd
