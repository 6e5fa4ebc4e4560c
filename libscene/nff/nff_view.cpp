#include "libscene/nff/nff_view.h"

#include "libscene/automatic_camera.h"
#include "libscene/base/error.h"

namespace masu::nff {
namespace {

constexpr Vec3d default_direction{-1, 2, -1.2}; // of the view
constexpr double default_angle = 45;
constexpr Vec3i default_resolution{512, 512, 0};

// The view's up if given, else +z, or +y when the view is along z.
Vec3d complete_up(const View& view, const Vec3d& forward) {
  constexpr double nearly_parallel = 1e-12;
  const Vec3d up = view.up.value_or(Vec3d{0, 0, 1});
  if (largest_magnitude(cross(direction(up), forward)) > nearly_parallel) return up;
  if (view.up)
    throw Error(ErrorCode::input, view.place, "the view's up is parallel to its line of sight: turn it");
  return {0, 1, 0};
}

} // namespace

Camera complete_view(const View& view, const Scene& scene) {
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
    const double distance = framing_distance(sphere.radius, camera.angle, camera.width, camera.height);
    const Vec3d back = direction(default_direction) * -distance;
    camera.at = view.look_at.value_or(sphere.center);
    camera.from = view.from.value_or(camera.at + back);
    if (camera.from == camera.at) camera.at = camera.from - back;
  }
  camera.up = complete_up(view, direction(camera.at - camera.from));
  return camera;
}

} // namespace masu::nff
