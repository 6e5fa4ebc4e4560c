// Lists of places, and the points of a scene's surfaces that are closest to them. One definition for both
// backends.
#pragma once

#include "libgrid/trace/closest.h"
#include "renderer/rays/hit_list.h"

namespace masu {

// Place i of a list, which has 3 numbers each, or is the origins of rays; relative to the scene's origin.
MASU_HD inline Vec3d place_at(const void* places, const RayFormat& format, std::size_t i) {
  const auto place = [first = i * static_cast<std::size_t>(format.numbers)](const auto* numbers) {
    return Vec3d{static_cast<double>(numbers[first]), static_cast<double>(numbers[first + 1]),
                 static_cast<double>(numbers[first + 2])};
  };
  return (format.is_float64 ? place(static_cast<const double*>(places))
                            : place(static_cast<const float*>(places))) -
         format.origin;
}

// Writes the distance of place i as t and t64, and what RayResults has besides of the closest point, but for
// `front`; where there is none, as of a miss. Structure: a hierarchy of the scene, NoStructure, or PlacedRay.
template <class Stored, class Structure>
MASU_HD inline void write_closest(const SceneView<Stored>& scene, const Structure& structure,
                                  const void* places, const RayFormat& format, const RayFilters& filters,
                                  const RayResults& results, std::size_t i) {
  const HitFilter filter = filter_of(structure, filters, i);
  const auto [closest, primitive] = closest_primitive(scene, structure, place_at(places, format, i), filter);
  const double distance = std::sqrt(closest.squared);
  if (results.t != nullptr) results.t[i] = static_cast<float>(distance);
  if (results.t64 != nullptr) results.t64[i] = distance;
  if (results.primitive != nullptr) results.primitive[i] = reported_primitive(structure, primitive);
  HitAttributes found;
  if (primitive != no_primitive) {
    const double length = std::sqrt(dot(closest.normal, closest.normal));
    const Vec3d normal = length > 0 ? closest.normal * (1 / length) : closest.normal;
    set_name(scene, structure, primitive, found);
    if (primitive < scene.triangle_count)
      set_on_triangle(found, scene, leaf_of(scene, structure, primitive).record, normal, closest.weight_b,
                      closest.weight_c);
    else
      found.normal = found.shading = cast<float>(normal);
    found.position = closest.point + format.origin;
  }
  write_attributes(found, results, i);
}

} // namespace masu
