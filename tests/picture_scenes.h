// Scenes in whose pictures float32's errors are seen, by one parameter each; and how far off pictures are.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tests/scene_builder.h"

#include <numbers>

namespace masu {

inline const Material picture_gray = matte({0.7F, 0.6F, 0.5F});

// Without objects.
inline Scene picture_scene(const Vec3d& from, const Vec3d& at, const Vec3d& light, std::int32_t side) {
  Scene scene{};
  scene.camera = {from, at, {0, 0, 1}, 40, 0.01, side, side};
  scene.has_camera = true;
  scene.background = {0.2F, 0.3F, 0.5F};
  scene.ambient = 0.3F;
  add_light(scene, light, {0.7, 0.7, 0.7});
  return scene;
}

// Balls of glass in each other, and mirrors, on a floor; of size 1 about a point.
inline Scene far_away(Chance& chance, double distance, std::int32_t side) {
  const Vec3d at = Vec3d{0.8, -1, 0.55} * distance;
  Scene scene = picture_scene(at + Vec3d{1.5, -2, 1.25}, at, at + Vec3d{2, -1, 3}, side);
  add_quad(scene, at + Vec3d{0, 0, -0.5}, {1.5, 0, 0}, {0, 1.5, 0}, picture_gray);
  add_quad(scene, at + Vec3d{0, 1.5, 0.5}, {1.5, 0, 0}, {0, 0, 1}, mirror());
  for (int i = 0; i < 6; ++i) {
    const Vec3d center =
        at + Vec3d{chance.uniform(-0.7, 0.7), chance.uniform(-0.7, 0.7), chance.uniform(-0.3, 0.5)};
    for (const double radius : {0.2, 0.15, 0.1})
      add_sphere(scene, center, radius, glass(1.5F));
  }
  return scene;
}

// Needles and pebbles of some size about a point of the floor.
inline void add_thicket(Scene& scene, Chance& chance, const Vec3d& at, double size) {
  const auto place = [&] { return at + Vec3d{chance.uniform(-size, size), chance.uniform(-size, size), 0}; };
  for (int i = 0; i < 60; ++i) {
    const Vec3d base = place();
    const Vec3d lean{chance.uniform(-0.2, 0.2) * size, chance.uniform(-0.2, 0.2) * size, size};
    add_cone(scene, {base, 0.02 * size, base + lean, chance.one_in(2) ? 0 : 0.02 * size}, picture_gray);
  }
  for (int i = 0; i < 10; ++i)
    add_sphere(scene, place() + Vec3d{0, 0, 0.1 * size}, 0.1 * size,
               chance.one_in(2) ? glass(1.5F) : mirror());
}

// Things as small as they are near, about a point of a floor of size 1.
inline Scene from_nearby(Chance& chance, const Vec3d& at, double distance, std::int32_t side) {
  Scene scene = picture_scene(at + Vec3d{0.5, -0.75, 0.45} * distance, at + Vec3d{0, 0, 0.075} * distance,
                              at + Vec3d{0.75, 0.5, 1.25} * distance, side);
  add_quad(scene, {0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, picture_gray);
  add_thicket(scene, chance, at, 0.25 * distance);
  return scene;
}

// The same things, as large in the picture, from so many times as far away.
inline Scene seen_from_afar(Chance& chance, double distance, std::int32_t side) {
  Scene scene = far_away(chance, 0, side);
  const Vec3d at{0, 0.2, 0}, back = normalized(Vec3d{1.5, -2, 1.25});
  scene.camera.at = at;
  scene.camera.from = at + back * (3 * distance);
  scene.camera.angle = 2 * std::atan(0.4 / distance) * 180 / std::numbers::pi;
  return scene;
}

struct Axes {
  Vec3d right, back, up; // of unit length
};
inline Axes tilted_axes(Chance& chance) {
  const Vec3d up = normalized(Vec3d{chance.uniform(-0.2, 0.2), chance.uniform(-0.2, 0.2), 1});
  const Vec3d right = normalized(cross(Vec3d{0, 1, 0}, up));
  return {right, cross(up, right), up};
}

// A tilted floor, and things above it by `gap`: many stripes, or a few sheets of glass.
inline Scene covered(Chance& chance, double gap, bool glassy, std::int32_t side) {
  Scene scene = picture_scene({0.6, -0.9, 0.7}, {0, 0, 0}, {0.4, 0.5, 1.5}, side);
  const auto [right, back, up] = tilted_axes(chance);
  add_quad(scene, {0, 0, 0}, right * 0.5, back * 0.5, picture_gray);
  const int count = glassy ? 4 : 16;
  for (int i = 0; i < count; ++i)
    add_quad(scene, back * (-0.45 + 0.9 * i / (count - 1)) + up * gap, right * 0.4, back * (0.3 / count),
             glassy ? glass(1.3F) : matte({0.1F, 0.4F, 0.2F}));
  return scene;
}

// A lens of glass, a disc of radius 1 that is so thick in its middle, before a chequered wall.
inline Scene thin_lens(Chance& chance, double thickness, std::int32_t side) {
  Scene scene = picture_scene({0.2, -4, 0.3}, {0, 0, 0}, {2, -3, 3}, side);
  for (int x = -4; x < 4; ++x) {
    for (int z = -4; z < 4; ++z)
      add_quad(scene, {0.5 * x + 0.25, 1, 0.5 * z + 0.25}, {0.25, 0, 0}, {0, 0, 0.25},
               (x + z) % 2 == 0 ? picture_gray : matte({0.1F, 0.2F, 0.6F}));
  }
  const double turn = chance.uniform(-0.2, 0.2);
  const Vec3d across{std::cos(turn), std::sin(turn), 0}, axis{-std::sin(turn), std::cos(turn), 0};
  const auto at = [&](int ring, int spoke, double face) {
    const double radius = ring / 16.0, angle = spoke * std::numbers::pi / 24;
    return across * (radius * std::cos(angle)) + Vec3d{0, 0, radius * std::sin(angle)} +
           axis * (face * thickness / 2 * (1 - radius * radius));
  };
  const Material material = glass(1.5F);
  for (int ring = 0; ring < 16; ++ring) {
    for (int spoke = 0; spoke < 48; ++spoke) {
      for (const double face : {-1.0, 1.0}) {
        const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
          face < 0 ? add_triangle(scene, a, b, c, material) : add_triangle(scene, a, c, b, material);
        };
        const Vec3d a = at(ring, spoke, face), b = at(ring + 1, spoke, face),
                    c = at(ring + 1, spoke + 1, face), d = at(ring, spoke + 1, face);
        if (ring > 0) add(a, b, d);
        add(b, c, d);
      }
    }
  }
  return scene;
}

// Upright needles off the middle of a floor of size 2; as wide as twice half_width(a random place aside).
template <class HalfWidth>
Scene needles_on_floor(Chance& chance, double length, std::int32_t side, const HalfWidth& half_width) {
  const Vec3d at{0.25, -0.125, 0};
  Scene scene =
      picture_scene(at + Vec3d{2.5, -4, 3} * length, at + Vec3d{0, 0, 0.4} * length, {1, 0.7, 1.5}, side);
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, picture_gray);
  for (int i = 0; i < 400; ++i) {
    const auto aside = [&](double by) { return Vec3d{chance.uniform(-by, by), chance.uniform(-by, by), 0}; };
    const Vec3d base = at + aside(2) * length, half = half_width(aside(1)) * length;
    add_triangle(scene, base - half, base + half, base + (aside(0.2) + Vec3d{0, 0, 1}) * length,
                 picture_gray);
  }
  return scene;
}

// Beads of glass of a radius in a heap, on a floor of size 2.
inline Scene beads(Chance& chance, double radius, std::int32_t side) {
  const Vec3d at{0.4, -0.3, 0};
  Scene scene =
      picture_scene(at + Vec3d{8, -14, 9} * radius, at + Vec3d{0, 0, 1} * radius, {1, 0.7, 1.5}, side);
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, picture_gray);
  for (int i = 0; i < 25; ++i) {
    const Vec3d center = at + Vec3d{2.1 * (i % 5 - 2), 2.1 * (i / 5 - 2), 1} * radius;
    add_sphere(scene, center + chance.direction() * (0.03 * radius), radius,
               chance.one_in(4) ? mirror() : glass(1.5F));
  }
  return scene;
}

// Long thin hairs of a radius, crossing each other over a floor of size 2.
inline Scene hair(Chance& chance, double radius, std::int32_t side) {
  Scene scene = picture_scene({0.7, -1.1, 0.8}, {0, 0, 0.1}, {0.5, 0.7, 1.5}, side);
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, picture_gray);
  for (int i = 0; i < 1500; ++i) {
    const Vec3d base{chance.uniform(-0.5, 0.5), chance.uniform(-0.5, 0.5), radius};
    const Vec3d tip =
        base + Vec3d{chance.uniform(-0.3, 0.3), chance.uniform(-0.3, 0.3), chance.uniform(0, 0.3)};
    add_cone(scene, {base, radius, tip, chance.one_in(2) ? radius : 0}, matte({0.5F, 0.3F, 0.1F}));
  }
  return scene;
}

// The share of pixels, between four rays each, of which a channel is off by more than a fiftieth.
inline double pixels_off(const Frame& a, const Frame& b) {
  const auto pixel = [](const Frame& frame, std::int32_t x, std::int32_t y) {
    const auto at = [&](std::int32_t column, std::int32_t row) {
      return frame.radiance[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                            static_cast<std::size_t>(column)];
    };
    return (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) * 0.25F;
  };
  int off = 0, all = 0;
  for (std::int32_t y = 0; y + 1 < a.rows; ++y)
    for (std::int32_t x = 0; x + 1 < a.columns; ++x, ++all)
      off += largest_magnitude(pixel(a, x, y) - pixel(b, x, y)) <= 0.02F ? 0 : 1; // NaN is off
  return static_cast<double>(off) / all;
}

} // namespace masu
