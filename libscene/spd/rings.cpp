// A pyramid of objects, each of six interlocked pentagonal rings, seen from its tip in front of a wall.
#include "libscene/spd/scenes.h"

#include <array>

namespace masu::spd {

namespace {

using Pentagon = std::array<Vec3d, 5>;
using Rings = std::array<Pentagon, 6>;

constexpr double thickness = 0.07412; // the radius of the rings' tubes

// Red, green, blue and their complements.
constexpr std::array<Vec3d, 6> colors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};

// The distance of layers. The first one is that far behind the origin, the camera as far in front of it.
double layer_distance() {
  return 1 / std::sin(radians(22.5));
}

// The pentagons lie in planes through the center, parallel to a dodecahedron's faces.
Rings interlocked_rings() {
  Rings rings{};
  for (std::size_t i = 0; i < 5; ++i)
    rings[0][i] = rotated(x_axis, z_axis, radians(72.0 * static_cast<double>(i))) * (1 / (1 + thickness));
  const double tilt = 2 * std::acos(std::cos(radians(60)) / std::sin(radians(36)));
  for (std::size_t k = 1; k < 6; ++k)
    for (std::size_t i = 0; i < 5; ++i)
      rings[k][i] =
          rotated(rotated(rings[0][i], x_axis, tilt), z_axis, radians(36.0 * static_cast<double>(2 * k - 1)));
  return rings;
}

void put_ring(NffWriter& nff, const Pentagon& ring, const Vec3d& center) {
  Vec3d previous = center + ring.back();
  for (const Vec3d& corner : ring) {
    const Vec3d position = center + corner;
    put_cone(nff, position, thickness, previous, thickness);
    put_sphere(nff, position, thickness);
    previous = position;
  }
}

void put_rings(NffWriter& nff, const Rings& rings, const Vec3d& center) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    put_material(nff, {colors[i].x, colors[i].y, colors[i].z, 0.5, 0.2, 3.0827, 0, 0});
    put_ring(nff, rings[i], center);
  }
}

// One layer behind the last, and 1 % wider than the view there.
void put_wall(NffWriter& nff, const Vec3d& camera, int size) {
  const double y = layer_distance() * (size + 1);
  const double half = 1.01 * std::tan(radians(22.5)) * (y - camera.y);
  const double left = camera.x - half, right = camera.x + half, low = camera.z - half, high = camera.z + half;
  put_material(nff, {1, 1, 1, 1, 0, 100000, 0, 0});
  put_polygon(nff, {{right, y, high}, {left, y, high}, {left, y, low}, {right, y, low}});
}

} // namespace

void write_rings(NffWriter& nff, int size, bool background) {
  const double step = layer_distance();
  const Vec3d camera = {-1, -step, 0.5};
  put_view(nff, {camera, camera + y_axis, z_axis, 1});
  put_lights(nff, {{3, -step, 3}, {-4, -step, 1}, {2, -step, -4}});
  if (background) put_wall(nff, camera, size);
  const Rings rings = interlocked_rings();
  for (int layer = 0; layer < size; ++layer)
    for (int row = 0; row <= layer; ++row)
      for (int column = 0; column <= layer; ++column)
        put_rings(nff, rings, {2.0 * column - layer, step * (layer + 1), 2.0 * row - layer});
}

} // namespace masu::spd
