#include "libscene/automatic_camera.h"

#include <cmath>
#include <numbers>

namespace masu {
namespace {

// With a sphere for each end of a cone.
Boxd rough_bounds(const Scene& scene) {
  Boxd box = empty_box<double>();
  const auto join_sphere = [&](const Vec3d& center, double radius) {
    box = join(box, grown(Boxd{center, center}, std::abs(radius)));
  };
  for (const SceneTriangle& triangle : scene.triangles)
    box = join(join(join(box, triangle.a), triangle.b), triangle.c);
  for (const Sphere<double>& sphere : scene.spheres)
    join_sphere(sphere.center, sphere.radius);
  for (const Cone<double>& cone : scene.cones) {
    join_sphere(cone.base, cone.base_radius);
    join_sphere(cone.apex, cone.apex_radius);
  }
  return is_empty(box) ? Boxd{{0, 0, 0}, {0, 0, 0}} : box;
}

} // namespace

Sphere<double> bounding_sphere(const Scene& scene) {
  const Boxd box = rough_bounds(scene);
  const Vec3d center = box.min * 0.5 + box.max * 0.5;
  const Vec3d half = box.max * 0.5 - box.min * 0.5;
  const double size = largest_magnitude(half);
  const double radius = size > 0 ? size * length(half * (1 / size)) : 0;
  const double min_radius = 1e-9 * largest_magnitude(center);
  if (radius > min_radius) return {center, radius};
  return {center, min_radius > 0 ? min_radius : 1};
}

double framing_distance(double radius, double angle, std::int32_t width, std::int32_t height) {
  const double narrowing = min(1.0, static_cast<double>(width) / height);
  const double half_angle = std::atan(narrowing * std::tan(angle / 2 * std::numbers::pi / 180));
  return max(radius / std::sin(half_angle), radius);
}

Vec3d direction(const Vec3d& v) {
  return normalized(v * (1 / largest_magnitude(v)));
}

} // namespace masu
