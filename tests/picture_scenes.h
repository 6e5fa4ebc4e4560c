// Scenes in whose pictures float32's errors are seen, by one parameter each; and how far off pictures are.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tests/scene_builder.h"

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
