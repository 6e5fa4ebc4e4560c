#include "libscene/float32_precision.h"

#include "libscene/file/scene_file.h"
#include "libscene/geometry/cone.h"
#include "libscene/geometry/margin.h"

#include <algorithm>

namespace masu {
namespace {

std::uint64_t count_too_small(const Scene& scene, double margin) {
  const auto is_too_small = [margin](const Boxd& box) {
    return largest_magnitude(box.max - box.min) < 2 * margin;
  };
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < scene.triangles.size();) {
    const auto object = scene.triangles[i].object;
    Boxd box = empty_box<double>();
    for (; i < scene.triangles.size() && scene.triangles[i].object == object; ++i)
      box = join(box, bounds(scene.triangles[i]));
    count += is_too_small(box) ? 1 : 0;
  }
  for (const auto& sphere : scene.spheres)
    count += is_too_small(bounds(sphere)) ? 1 : 0;
  for (const auto& cone : scene.cones)
    count += is_too_small(bounds(cone)) ? 1 : 0;
  return count;
}

} // namespace

Float32Precision float32_precision(const Scene& scene) {
  const Boxd box = bounds(scene);
  if (is_empty(box)) return {0, 1, 0, 0};
  const double margin = rounding_margin<float>(box);
  const auto flattened = std::count_if(scene.cones.begin(), scene.cones.end(), [](const Cone<double>& cone) {
    return cast<float>(cone.base) == cast<float>(cone.apex);
  });
  return {margin, largest_magnitude(box.max - box.min), count_too_small(scene, margin),
          static_cast<std::uint64_t>(flattened)};
}

} // namespace masu
