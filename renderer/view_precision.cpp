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
// The eye's coordinates are rounded as well: √3 u M, and by its distance from the bounds.
constexpr double picture_roundings = 32;

// And what camera rays turn by (camera.h), times their length: forward, two sums and the unit length are
// rounded once each; right and up, and their factors, three times, times how far from the middle they reach.
// The eye's distance is rounded once.
constexpr double direction_roundings = 5, reach_roundings = 6;

// In robust's sample secondary rays start so many times as far off their surfaces as they do in its picture:
// where that matters it does in the picture, too, if more rarely, and so a sample shows shares of a picture
// that it is too small for.
constexpr float enlarged_offset = 32;

// Of glass in glass each level may double the rays: the sample takes no more levels than pictures usually do.
constexpr int most_depth = 5;

// Of the sample's rays. A channel that is off by more than a twelfth leaves each of the four pixels around it
// off by a fiftieth. Of standard scenes one ray at most was seen to differ.
constexpr float visible = 1.0F / 12;
constexpr int differing_allowed = 4;

// How far a point is outside a box; 0 within.
double distance_to(const Boxd& box, const Vec3d& p) {
  Vec3d outside{};
  for (int axis = 0; axis < 3; ++axis)
    outside.set(axis, std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0}));
  return length(outside);
}

// A sample of camera rays and what they see.
Frame sampled(const ResidentTracer& tracer, const FrameRequest& picture, Precision precision, float offset) {
  FrameRequest sample{.tracing = {.precision = precision},
                      .camera = picture.camera,
                      .sampling = Sampling::sparse,
                      .hither = picture.hither,
                      .rules = picture.rules,
                      .hits = true};
  sample.rules.depth = std::min(picture.rules.depth, most_depth);
  sample.rules.offset = offset;
  return tracer.render(sample);
}

int differing_rays(const Frame& a, const Frame& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i)
    count += largest_magnitude(a.radiance[i] - b.radiance[i]) <= visible ? 0 : 1; // NaN differs
  return count;
}

} // namespace

ViewPrecision view_precision(const ResidentTracer& tracer, const FrameRequest& request) {
  const SceneFile& scene = tracer.scene();
  const Boxd bounds = scene.bounds();
  ViewPrecision chosen;
  chosen.pixel = std::numeric_limits<double>::infinity();
  if (scene.is_float64()) return {Precision::doubled, true, 0, chosen.pixel, 0};
  if (is_empty(bounds)) return chosen;
  constexpr double u = static_cast<double>(RealTraits<float>::unit_roundoff);
  const Camera camera = relative_to(scene.origin(), request.camera);
  const double up = std::tan(camera.angle * std::numbers::pi / 360), pixel_at_1 = 2 * up / camera.height;
  const double reach = up * std::hypot(1.0, static_cast<double>(camera.width) / camera.height);
  const auto is_fine_at = [&](double distance) {
    chosen.error = u * (picture_roundings * largest_magnitude(bounds) +
                        (direction_roundings + reach_roundings * reach) * distance);
    chosen.pixel = pixel_at_1 * distance;
    return chosen.error <= share_of_pixel * chosen.pixel;
  };
  const Frame exact = sampled(tracer, request, Precision::doubled, 1);
  if (!is_fine_at(distance_to(bounds, camera.from))) {
    const double nearest = static_cast<double>(std::ranges::min(exact.hits, {}, &HitRecord::t).t);
    // From where rays start, or farther.
    if (!is_fine_at(nearest + (request.hither ? max(camera.hither, 0.0) : 0))) {
      chosen.precision = Precision::doubled;
      return chosen;
    }
  }
  chosen.differing = differing_rays(sampled(tracer, request, Precision::robust, enlarged_offset), exact);
  if (chosen.differing > differing_allowed) chosen.precision = Precision::doubled;
  return chosen;
}

std::string description_of(const ViewPrecision& chosen) {
  if (chosen.is_stored) return "double: the scene is stored as float64";
  if (std::isinf(chosen.pixel)) return "robust: no surface is in the picture";
  if (chosen.precision == Precision::doubled && chosen.differing > differing_allowed)
    return fmt::format("double: {} of {} sampled rays see other colours in float32", chosen.differing,
                       sparse_side * sparse_side);
  return fmt::format(
      "{}: float32's error across a ray is up to {:.2g}, a pixel at the nearest surface {:.2g}",
      name_of(chosen.precision), chosen.error, chosen.pixel);
}

} // namespace masu
