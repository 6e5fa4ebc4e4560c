// Buffered NFF text. Every line of it is a keyword and numbers; these are written with six significant
// digits.
#pragma once

#include "libscene/spd/frame.h"

#include <cstdio>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace masu::spd {

struct NffWriter {
  NffWriter(std::FILE* out, std::string place);

  std::FILE* out;
  std::string place; // names `out` in errors
  std::string text;  // waits to be written; bounded
};

// The eye, and what most scenes share.
struct View {
  Vec3d from{}, at{}, up{};
  double hither = 1; // nothing nearer is seen
  Vec3d background = {0.078, 0.361, 0.753};
  double angle = 45;    // that the image spans, in degrees
  int resolution = 512; // pixels each way
};

struct Material {
  double red, green, blue;
  double diffuse, specular, shine;
  double transmittance, index_of_refraction;
};

// A corner with the surface's unit normal there.
struct Corner {
  Vec3d at, normal;
};

// All of these throw Error(output) when the file takes no more.
void put_view(NffWriter& nff, const View& view);
void put_light(NffWriter& nff, const Vec3d& at);
void put_material(NffWriter& nff, const Material& material);
void put_sphere(NffWriter& nff, const Vec3d& center, double radius);
void put_cone(NffWriter& nff, const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius);
void put_polygon(NffWriter& nff, std::span<const Vec3d> corners);
void put_polygon(NffWriter& nff, std::initializer_list<Vec3d> corners);
void put_triangle(NffWriter& nff, const Corner& a, const Corner& b, const Corner& c);

// Writes what is still buffered and flushes the file.
void finish(NffWriter& nff);

} // namespace masu::spd
