#include "renderer/view_precision.h"

#include "libscene/geometry/margin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace masu {
namespace {

constexpr double share_of_pixel = 1.0 / 16;

// Of the error bound (margin.h) a picture shows what is across the ray: 8 u M of clipping, 2√3 u M of
// subtracting and 3 u 2√3 M of projecting make 22 u M for triangles; of spheres and cones no more was found.
constexpr double picture_roundings = 32;

// How far a point is outside a box; 0 within.
double distance_to(const Boxd& box, const Vec3d& p) {
  Vec3d outside{};
  for (int axis = 0; axis < 3; ++axis)
    outside.set(axis, std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0}));
  return length(outside);
}

// Of the surfaces that a sample of camera rays meets, from where the rays start.
double nearest_hit_of(const Tracer& tracer, const FrameRequest& picture) {
  FrameRequest sample;
  sample.tracing.precision = Precision::doubled;
  sample.camera = picture.camera;
  sample.sampling = Sampling::sparse;
  sample.hither = picture.hither;
  sample.shaded = false;
  sample.hits = true;
  const Frame frame = tracer.render(sample);
  return static_cast<double>(std::ranges::min(frame.hits, {}, &HitRecord::t).t);
}

} // namespace

ViewPrecision view_precision(const Tracer& tracer, const FrameRequest& request) {
  const SceneFile& scene = tracer.scene();
  const Boxd bounds = scene.bounds();
  ViewPrecision chosen;
  chosen.pixel = std::numeric_limits<double>::infinity();
  if (scene.is_float64()) return {Precision::doubled, true, 0, chosen.pixel};
  if (is_empty(bounds)) return chosen;
  chosen.error_bound = rounding_margin<float>(bounds) * picture_roundings / margin_roundings;
  const Camera camera = relative_to(scene.origin(), request.camera);
  const double pixel_at_1 = 2 * std::tan(camera.angle * std::numbers::pi / 360) / camera.height;
  const auto is_fine = [&](double distance) {
    return chosen.error_bound <= share_of_pixel * pixel_at_1 * distance;
  };
  double distance = distance_to(bounds, camera.from);
  if (!is_fine(distance)) {
    distance = nearest_hit_of(tracer, request);
    if (request.hither) distance += max(camera.hither, 0.0); // where rays start, or farther
    if (!is_fine(distance)) chosen.precision = Precision::doubled;
  }
  chosen.pixel = pixel_at_1 * distance;
  return chosen;
}

std::string description_of(const ViewPrecision& chosen) {
  if (chosen.precision == Precision::robust) return name_of(chosen.precision);
  if (chosen.is_stored) return "double: the scene is stored as float64";
  return fmt::format("double: the error bound of float32 is {:.2g}; a pixel at the nearest surface is {:.2g}",
                     chosen.error_bound, chosen.pixel);
}

} // namespace masu
