// Queries of a list's rays that need hits in their order: all of them, their number, those of one side, or
// of chosen primitives. One definition for both backends.
#pragma once

#include "libgrid/trace/hits_in_order.h"
#include "renderer/rays/ray_query.h"

namespace masu {

// What rays of a list don't hit, each null where that is nothing; and of placed meshes (placed_rays.h), for
// each ray or null, the object that its excluded primitive is of, and its world.
struct RayFilters {
  const PrimitiveIndex* excluded = nullptr;    // a primitive for each ray, or no_primitive
  const std::uint32_t* ray_masks = nullptr;    // for each ray; null: all bits
  const std::uint32_t* object_masks = nullptr; // for each object
  std::size_t object_count = 0;                // of object_masks: all of the scene's
  const std::uint32_t *excluded_objects = nullptr, *worlds = nullptr;

  bool any() const { return excluded != nullptr || ray_masks != nullptr || object_masks != nullptr; }
  bool any_of_placed() const { return excluded_objects != nullptr || worlds != nullptr; }
  // Of ray i, with faces and edges as they are by default.
  MASU_HD HitFilter of(std::size_t i) const {
    HitFilter filter;
    if (excluded != nullptr) filter.excluded = excluded[i];
    filter.object_masks = object_masks;
    if (ray_masks != nullptr) filter.ray_mask = ray_masks[i];
    return filter;
  }
};

// What is asked of each ray. With Faces::both, no filters and no t64, nearest_hit and occlusion are
// trace_listed()'s, with the same results.
struct HitRules {
  Query query = Query::nearest_hit;
  Faces faces = Faces::both;
  std::uint32_t limit = 1; // hits per ray, of all_hits

  // Elements per ray of the arrays of hits.
  MASU_HD std::uint32_t row() const { return query == Query::all_hits ? limit : 1; }
};

// What depends on how a scene's primitives are held (placed_rays.h): what a ray doesn't hit, and the numbers
// of its hits.
template <class Structure>
MASU_HD inline HitFilter filter_of(const Structure&, const RayFilters& filters, std::size_t i) {
  return filters.of(i);
}
template <class Structure>
MASU_HD inline PrimitiveIndex reported_primitive(const Structure&, PrimitiveIndex primitive) {
  return primitive;
}

// Writes of ray i's nearest hit what follows from its number.
template <class Real, class Stored, class Structure>
MASU_HD inline void write_named(const SceneView<Stored>& scene, const Structure&, const Ray<Real>& ray,
                                const Hit<float>& hit, const RayResults& results, std::size_t i) {
  if (results.has_attributes()) write_attributes(scene, NoStructure{}, ray, hit, results, i);
}

// Writes the results of ray i.
template <class M, class Stored, class Structure>
MASU_HD inline void write_hits(const SceneView<Stored>& scene, const Structure& structure,
                               Ray<typename M::Real> ray, const RayFilters& filters, const HitRules& rules,
                               const RayResults& results, std::size_t i) {
  using Real = typename M::Real;
  using Near = NearHit<typename M::TestRay>;
  const bool counts_all = rules.query == Query::count_hits, lists = rules.query == Query::all_hits;
  HitFilter filter = filter_of(structure, filters, i);
  filter.faces = rules.faces;
  filter.edges = counts_all || lists ? EdgeRule::half_open : EdgeRule::closed;
  const Real scale = scale_direction(ray);
  const std::size_t first = i * rules.row();
  const auto write = [&](std::uint32_t k, const Near& near, Real t, bool front) {
    if (results.t != nullptr) results.t[first + k] = static_cast<float>(t);
    if (results.t64 != nullptr) results.t64[first + k] = static_cast<double>(t);
    if (results.primitive != nullptr)
      results.primitive[first + k] = reported_primitive(structure, near.hit.primitive);
    if (results.front != nullptr) results.front[first + k] = front ? 1 : 0;
    if (results.has_attributes()) write_attributes(scene, structure, near, results, first + k);
  };
  const bool writes = lists || rules.query == Query::nearest_hit;
  std::int32_t leaves = 0; // how often more than it enters
  const std::uint32_t count =
      hits_in_order<M>(scene, structure, ray, filter, counts_all ? no_primitive : rules.row(),
                       [&](std::uint32_t k, const Near& near, bool front) {
                         leaves += front ? -1 : 1;
                         if (writes) write(k, near, (near.hit.t + near.skipped) * scale, front);
                       });
  if (writes) {
    for (std::uint32_t k = count; k < rules.row(); ++k)
      write(k, {{}, {0, no_primitive}, 0}, static_cast<Real>(INFINITY), false);
  }
  if (results.count != nullptr) results.count[i] = count;
  if (results.inside != nullptr)
    results.inside[i] = static_cast<std::uint8_t>(leaves == 0 || leaves == 1 ? leaves : 2);
  if (results.occluded != nullptr) results.occluded[i] = count != 0 ? 1 : 0;
}

} // namespace masu
