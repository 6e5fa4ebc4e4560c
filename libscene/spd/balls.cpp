// Sphereflake: every sphere has nine children of a third of its radius, tangent to it, recursively.
#include "libscene/spd/scenes.h"

#include <array>

namespace masu::spd {

namespace {

using Directions = std::array<Vec3d, 9>;

// Directions to the children of a sphere facing +z: three neighbours, tilted to lie between equator and pole,
// and two copies, rotated by a third of a turn either way.
Directions child_directions() {
  const double half = std::sqrt(0.5);
  const std::array<Vec3d, 3> trio = {{{half, half, 0}, {half, 0, -half}, {0, half, -half}}};
  const Vec3d hinge = {half, -half, 0};
  const double tilt = std::asin(2 / std::sqrt(6.0));
  Directions directions{};
  std::size_t i = 0;
  for (const double turn : {0, 120, 240})
    for (const Vec3d& v : trio)
      directions[i++] = rotated(rotated(v, hinge, tilt), z_axis, radians(turn));
  return directions;
}

// The shortest rotation from +z to a unit direction. Near the poles, where its axis is ill-defined, the
// scene's definition uses the identity and half a turn about y.
Frame frame_facing(const Vec3d& d) {
  if (d.z >= 0.9999) return {x_axis, y_axis, z_axis};
  if (d.z <= -0.9999) return {-x_axis, y_axis, -z_axis};
  const double k = 1 / (1 + d.z);
  return {{1 - k * d.x * d.x, -k * d.x * d.y, -d.x}, {-k * d.x * d.y, 1 - k * d.y * d.y, -d.y}, d};
}

struct Ball {
  Vec3d center, direction; // direction: unit vector away from the parent
  double radius;
};

void put_flake(NffWriter& nff, const Directions& children, const Ball& ball, int depth) {
  put_sphere(nff, ball.center, ball.radius);
  if (depth == 0) return;
  const Frame frame = frame_facing(ball.direction);
  const double child_radius = ball.radius / 3;
  for (const Vec3d& child : children) {
    const Vec3d direction = from_frame(frame, child);
    const Vec3d center = ball.center + direction * (ball.radius + child_radius);
    put_flake(nff, children, {center, direction, child_radius}, depth - 1);
  }
}

} // namespace

void write_balls(NffWriter& nff, int size, bool background) {
  put_view(nff, {{2.1, 1.3, 1.7}, {0, 0, 0}, z_axis, 0.01});
  put_lights(nff, {{4, 3, 2}, {1, -4, 4}, {-3, 1, 5}});
  if (background) {
    put_material(nff, {1, 0.75, 0.33, 0.8, 0, 100000, 0, 1});
    put_polygon(nff, {{12, 12, -0.5}, {-12, 12, -0.5}, {-12, -12, -0.5}, {12, -12, -0.5}});
  }
  put_material(nff, {1, 0.9, 0.7, 0.5, 0.5, 3.0827, 0, 1});
  put_flake(nff, child_directions(), {{0, 0, 0}, z_axis, 0.5}, size);
}

} // namespace masu::spd
