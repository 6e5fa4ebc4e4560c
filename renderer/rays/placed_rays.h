// Queries of placed meshes: how rays see them, and how hits on them are named. One definition for both
// backends.
//
// A triangle's hit is named by its placement, as the object, and its number in the mesh; that of what stands
// beside them by its object, which follow the placements, and its number among the spheres, then cones.
#pragma once

#include "libgrid/placed/placed_closest.h"
#include "renderer/rays/hit_list.h"

namespace masu {

// Placed meshes, as the rays of a list see them.
template <class Stored>
struct PlacedList {
  PlacedView<Stored> placed;
  RayFilters filters;
};
template <class Stored>
MASU_HD inline PlacedRay<Stored> seen_by(const PlacedList<Stored>& list, std::size_t i) {
  const RayFilters& filters = list.filters;
  PlacedRay<Stored> ray{list.placed};
  if (filters.worlds != nullptr) ray.world = filters.worlds[i];
  if (filters.excluded_objects != nullptr) ray.excluded_object = filters.excluded_objects[i];
  if (filters.ray_masks != nullptr) ray.mask = filters.ray_masks[i];
  ray.object_masks = filters.object_masks;
  return ray;
}

template <class Stored>
MASU_HD inline HitFilter filter_of(const PlacedRay<Stored>& seen, const RayFilters& filters, std::size_t i) {
  const PlacedView<Stored>& placed = seen.placed;
  HitFilter filter = filters.of(i); // masks: of what stands beside, as surface_of() numbers its objects
  if (filter.object_masks != nullptr) filter.object_masks += placed.count;
  if (filter.excluded == no_primitive) return filter;
  const std::uint32_t object = seen.excluded_object, primitive = filter.excluded;
  const std::uint64_t first = placed.first_triangles[object < placed.count ? object : placed.count],
                      number = first + primitive;
  const bool is_there = object < placed.count ? number < placed.first_triangles[object + 1]
                                              : object != no_primitive && number < no_primitive;
  filter.excluded = is_there ? static_cast<PrimitiveIndex>(number) : no_primitive;
  return filter;
}

template <class Stored>
MASU_HD inline PrimitiveIndex reported_primitive(const PlacedRay<Stored>& seen, PrimitiveIndex number) {
  const PlacedView<Stored>& placed = seen.placed;
  if (number == no_primitive) return number;
  const std::uint32_t triangles = placed.triangle_count();
  return number - (number < triangles ? placed.first_triangles[placed.placement_of(number)] : triangles);
}

// Of a triangle's number, or of what stands beside.
template <class Stored>
MASU_HD inline void set_name(const SceneView<Stored>& scene, const PlacedRay<Stored>& seen,
                             PrimitiveIndex number, HitAttributes& found) {
  const PlacedView<Stored>& placed = seen.placed;
  if (number >= scene.triangle_count) {
    found.object = placed.count + surface_of(scene, number).object;
    found.face = number - scene.triangle_count;
  } else {
    found.object = placed.placement_of(number);
    found.face = number - placed.first_triangles[found.object];
  }
}
template <class Stored>
MASU_HD inline Leaf<Stored> leaf_of(const SceneView<Stored>& scene, const PlacedRay<Stored>& seen,
                                    PrimitiveIndex number) {
  return number < scene.triangle_count ? seen.placed.leaf(number) : leaf_of(scene, number);
}

// Names ray i's nearest hit, given by its number, whose t counts from its own origin.
template <class Real, class Stored>
MASU_HD inline void write_named(const SceneView<Stored>& scene, const PlacedRay<Stored>& seen,
                                const Ray<Real>& ray, const Hit<float>& hit, const RayResults& results,
                                std::size_t i) {
  if (results.primitive != nullptr) results.primitive[i] = reported_primitive(seen, hit.primitive);
  if (results.has_attributes()) write_attributes(scene, seen, ray, hit, results, i);
}

} // namespace masu
