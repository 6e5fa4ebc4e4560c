#include "libscene/mesh/points.h"
#include "libscene/base/parallel.h"

#include <algorithm>

namespace masu {

void place_points(GrowingArray<SceneTriangle>& triangles) {
  const auto is_surface = [](const Triangle<double>& triangle) { return has_surface(triangle); };
  const SceneTriangle* const first = std::find_if(triangles.begin(), triangles.end(), is_surface);
  const Vec3d place = first != triangles.end() ? first->a : points_without_surface;
  parallel_for(triangles.size(), [&](std::size_t i) {
    SceneTriangle& triangle = triangles[i];
    if (!is_surface(triangle)) triangle.a = triangle.b = triangle.c = place;
  });
}

} // namespace masu
