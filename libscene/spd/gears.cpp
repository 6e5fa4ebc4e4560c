// Layers of meshing gears over a mirror; the faces of gears are concave polygons of 144 corners.
#include "libscene/spd/scenes.h"

#include <algorithm>
#include <array>

namespace masu::spd {

namespace {

constexpr int teeth = 36;
constexpr double tooth_angle = 2 * std::numbers::pi / teeth;
constexpr double tooth_depth = 0.1; // of the gear's radius

using Outline = std::array<Vec3d, 4 * teeth>;

// Index in the block of size^3 gears: column along x, row along y, layer from the top downwards.
struct GearIndex {
  int column, row, layer;
};

// Two corners on a tooth's tip, two in the gap after it; rotated by `turn`, in radians.
Outline gear_outline(double radius, double turn) {
  // Tips don't quite reach the bottom of the neighbours' gaps.
  const double tip = 0.995 * radius, gap = (1 - tooth_depth) * radius;
  Outline outline{};
  std::size_t i = 0;
  const auto add = [&](double r, double teeth_round) {
    const double angle = turn + tooth_angle * teeth_round;
    outline[i++] = {r * std::cos(angle), r * std::sin(angle), 0};
  };
  for (int tooth = 0; tooth < teeth; ++tooth) {
    add(tip, tooth - 0.19);
    add(tip, tooth + 0.19);
    add(gap, tooth + 0.3);
    add(gap, tooth + 0.7);
  }
  return outline;
}

// Each channel cycles through seven levels with its own stride; the color is scaled to a maximum of 1.
Vec3d gear_color(const GearIndex& p) {
  const int r = (5 + p.column + 3 * p.row + 5 * p.layer) % 7;
  const int g = (3 + 3 * p.column + 2 * p.row + 6 * p.layer) % 7;
  const int b = (2 + 4 * p.column + 2 * p.row + 6 * p.layer) % 7;
  constexpr double offset = 0.07; // no channel is zero
  return Vec3d{r + offset, g + offset, b + offset} * (1 / (std::max({r, g, b}) + offset));
}

void put_gear_material(NffWriter& nff, const GearIndex& p) {
  const Vec3d color = gear_color(p);
  const bool glass = (4 * p.column + 2 * p.row + p.layer) % 5 == 0;
  if (glass)
    put_material(nff, {color.x, color.y, color.z, 0.2, 0, 100000, 0.8, 1.1});
  else
    put_material(nff, {color.x, color.y, color.z, 1, 0, 100000, 0, 0});
}

// All polygons are counter-clockwise seen from outside. `center`: of the top face.
void put_gear(NffWriter& nff, const Outline& outline, const Vec3d& center, double thickness) {
  constexpr std::size_t n = std::tuple_size_v<Outline>;
  Outline top{}, bottom{}, seen_from_below{};
  for (std::size_t i = 0; i < n; ++i) {
    top[i] = center + outline[i];
    bottom[i] = top[i] - z_axis * thickness;
    seen_from_below[(n + 1 - i) % n] = bottom[i];
  }
  put_polygon(nff, top);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    put_polygon(nff, {top[i], bottom[i], bottom[next], top[next]});
  }
  put_polygon(nff, seen_from_below);
}

} // namespace

void write_gears(NffWriter& nff, int size, bool background) {
  put_view(nff, {{-1.1, -2.1, 2.6}, {0, 0, 0}, z_axis, 1});
  put_lights(nff, {{2, 4, 4}, {-2, 4, 3}, {2, -2.5, 2.5}, {-1, -4, 2}, {-1.111, -2.121, 2.626}});
  if (background) {
    put_material(nff, {1, 0.85, 0.7, 0.3, 0.6, 3.0827, 0, 0});
    put_polygon(nff, {{2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}});
  }

  // Neighbours are closer than two radii by a tooth's depth, so that they mesh; a row spans [-1, 1].
  const double radius = 1 / (size - (size - 1) * tooth_depth / 2);
  const double step = (2 - tooth_depth) * radius;
  const double thickness = std::min(0.1, 0.5 / size);
  const std::array<Outline, 2> outlines = {gear_outline(radius, 0), gear_outline(radius, tooth_angle / 2)};
  for (int layer = 0; layer < size; ++layer)
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const GearIndex index = {column, row, layer};
        const Vec3d center = {radius - 1 + step * column, radius - 1 + step * row,
                              1 - static_cast<double>(layer) / size};
        put_gear_material(nff, index);
        put_gear(nff, outlines[static_cast<std::size_t>((column + row + layer) % 2)], center, thickness);
      }
}

} // namespace masu::spd
