#include "renderer/rays/closest_points.h"

#include "libgrid/trace/closest.h"
#include "libscene/base/error.h"
#include "renderer/rays/list_progress.h"
#include "renderer/rays/place_list.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace masu {
namespace {

template <class Stored>
void write(const SceneView<Stored>& scene, const ClosestPrimitive& found, const Vec3d& origin,
           const RayResults& results, std::size_t i) {
  const auto& [closest, primitive] = found;
  const bool is_there = primitive != no_primitive;
  const double distance = std::sqrt(closest.squared);
  if (results.t != nullptr) results.t[i] = static_cast<float>(distance);
  if (results.t64 != nullptr) results.t64[i] = distance;
  if (results.primitive != nullptr) results.primitive[i] = primitive;
  HitAttributes found_there;
  if (is_there) {
    const double length = std::sqrt(dot(closest.normal, closest.normal));
    const Vec3d normal = length > 0 ? closest.normal * (1 / length) : closest.normal;
    found_there.object = surface_of(scene, primitive).object;
    found_there.face = face_of(scene, primitive);
    if (primitive < scene.triangle_count)
      set_on_triangle(found_there, scene, scene.triangles[primitive], normal, closest.weight_b,
                      closest.weight_c);
    else
      found_there.normal = found_there.shading = cast<float>(normal);
    found_there.position = closest.point;
  }
  write_attributes(found_there, results, i);
  to_list(0, origin, results, i, 1);
}

} // namespace

void closest_points(const SceneFile& scene, const StructureFile* hierarchy, const RayList& places,
                    const RayResults& results, const std::function<void(double)>& progress) {
  check_filters(places.filters, scene.counts().objects);
  if (const Boxd bounds = scene.bounds(); !is_empty(bounds) && largest_magnitude(bounds) > max_closest)
    throw Error(ErrorCode::usage, "scene", "has coordinates beyond 1e37, too large for distances");
  ListProgress list_progress(progress, places.count, 16, hierarchy == nullptr ? scene.primitive_count() : 0);
  const auto search = [&](const auto& view, const auto& structure) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.count, 256), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        const HitFilter filter = places.filters.of(i);
        write(view, closest_primitive(view, structure, place_at(places.rays, places.format, i), filter),
              places.format.origin, results, i);
        list_progress.done(i);
      }
    });
  };
  scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    hierarchy == nullptr ? search(view, NoStructure{}) : search(view, hierarchy->hierarchy_view<Stored>());
  });
}

} // namespace masu
