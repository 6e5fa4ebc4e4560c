#include "libscene/automatic_camera.h"

#include "libscene/mesh/indexed_mesh.h"
#include "libscene/scene_bounds.h"

#include <cmath>
#include <numbers>

namespace masu {
namespace {

// Of a cone, that of a sphere for each end.
Boxd rough_box(const auto& record) {
  return bounds(record);
}
Boxd rough_box(const Cone<double>& c) {
  return join(bounds(Sphere<double>{c.base, c.base_radius}), bounds(Sphere<double>{c.apex, c.apex_radius}));
}

} // namespace

template <class Triangles>
Sphere<double> bounding_sphere(const SceneOf<Triangles>& scene) {
  Boxd box = joined_boxes(scene, [](const auto& record) { return rough_box(record); });
  if (is_empty(box)) box = {{0, 0, 0}, {0, 0, 0}};
  const Vec3d center = box.min * 0.5 + box.max * 0.5;
  const Vec3d half = box.max * 0.5 - box.min * 0.5;
  const double size = largest_magnitude(half);
  const double radius = size > 0 ? size * length(half * (1 / size)) : 0;
  const double min_radius = 1e-9 * largest_magnitude(center);
  if (radius > min_radius) return {center, radius};
  return {center, min_radius > 0 ? min_radius : 1};
}
template Sphere<double> bounding_sphere(const Scene&);
template Sphere<double> bounding_sphere(const ArrayScene&);

double framing_distance(double radius, double angle, std::int32_t width, std::int32_t height) {
  const double narrowing = min(1.0, static_cast<double>(width) / height);
  const double half_angle = std::atan(narrowing * std::tan(angle / 2 * std::numbers::pi / 180));
  return max(radius / std::sin(half_angle), radius);
}

Camera automatic_camera(const Sphere<double>& whole, bool is_y_up, std::int32_t width, std::int32_t height) {
  constexpr double angle = 45;
  const Vec3d up = is_y_up ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
  const Vec3d forward = direction(is_y_up ? Vec3d{-1, -1.2, -2} : Vec3d{-1, 2, -1.2});
  const Vec3d from = whole.center - forward * framing_distance(whole.radius, angle, width, height);
  return {from, whole.center, up, angle, 0.01, width, height};
}

Vec3d direction(const Vec3d& v) {
  return normalized(v * (1 / largest_magnitude(v)));
}

} // namespace masu
