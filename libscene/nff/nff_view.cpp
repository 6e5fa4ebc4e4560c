#include "libscene/nff/nff_view.h"

#include <cmath>
#include <numbers>

namespace masu::nff {
namespace {

constexpr Vec3d default_direction{-1, 2, -1.2}; // of the view
constexpr double default_angle = 45;
constexpr Vec3i default_resolution{512, 512, 0};

// Bounds of the scene, with a sphere for each end of a cone: not tight, but enough for a view.
Boxd rough_bounds(const Scene& scene) {
  Boxd box = empty_box<double>();
  const auto join_sphere = [&](const Vec3d& center, double radius) {
    box = join(box, grown(Boxd{center, center}, std::abs(radius)));
  };
  for (const Triangle<double>& triangle : scene.triangles)
    box = join(join(join(box, triangle.a), triangle.b), triangle.c);
  for (const Sphere<double>& sphere : scene.spheres)
    join_sphere(sphere.center, sphere.radius);
  for (const Cone<double>& cone : scene.cones) {
    join_sphere(cone.base, cone.base_radius);
    join_sphere(cone.apex, cone.apex_radius);
  }
  return is_empty(box) ? Boxd{{0, 0, 0}, {0, 0, 0}} : box;
}

// v normalised, also when its square is out of a double's range.
Vec3d direction(const Vec3d& v) {
  return normalized(v * (1 / largest_magnitude(v)));
}

// Its radius is never so small that the camera would round to its centre.
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

// The view's up if given, else +z, or +y when the view is along z.
Vec3d complete_up(const View& view, const Vec3d& forward, const Text& text) {
  constexpr double nearly_parallel = 1e-12;
  const Vec3d up = view.up.value_or(Vec3d{0, 0, 1});
  if (largest_magnitude(cross(direction(up), forward)) > nearly_parallel) return up;
  if (view.up) fail(text, view.position, "the view's up is parallel to its line of sight: turn it");
  return {0, 1, 0};
}

} // namespace

Camera complete_view(const View& view, const Scene& scene, const Text& text) {
  Camera camera{};
  camera.angle = view.angle.value_or(default_angle);
  camera.hither = view.hither.value_or(0.01);
  const Vec3i resolution = view.resolution.value_or(default_resolution);
  camera.width = resolution.x;
  camera.height = resolution.y;
  if (view.from && view.look_at) {
    camera.from = *view.from;
    camera.at = *view.look_at;
  } else {
    const Sphere<double> sphere = bounding_sphere(scene);
    // The sphere fills the smaller of the image's height and width.
    const double narrowing = min(1.0, static_cast<double>(camera.width) / camera.height);
    const double half_angle = std::atan(narrowing * std::tan(camera.angle / 2 * std::numbers::pi / 180));
    const double distance = max(sphere.radius / std::sin(half_angle), sphere.radius);
    const Vec3d back = direction(default_direction) * -distance;
    camera.at = view.look_at.value_or(sphere.center);
    camera.from = view.from.value_or(camera.at + back);
    if (camera.from == camera.at) camera.at = camera.from - back;
  }
  camera.up = complete_up(view, direction(camera.at - camera.from), text);
  return camera;
}

} // namespace masu::nff
