// The nearest hit of a ray, and whether anything blocks it: through a grid, or without one by trying every
// primitive. Either way the same bits come out.
#pragma once

#include "libgrid/grid/grid_walk.h"
#include "libgrid/hierarchy/walk/hierarchy_walk.h"
#include "libgrid/hierarchy/walk/walks_in_use.h"
#include "libgrid/structure/structure_records.h"
#include "libscene/geometry/clip.h"
#include "libscene/geometry/intersect.h"

#ifdef MASU_HOST_AVX2
#include "libgrid/hierarchy/walk/nearest_first_avx2.h"
#endif

#include <type_traits>

namespace masu {

// In a grid's place: every primitive is tried.
struct NoStructure {};

// When the search for the nearest hit ends: once nothing that is still to come can be nearer; or, as the
// 2012 thesis did (docs/algorithm.md), with the first cell where anything is hit, wherever that hit lies:
// sooner, and sometimes wrong.
enum class StopRule { proven, first_cell };

// nearest_hit: the hit of smallest t. occlusion: whether anything is hit (Embree: any hit). all_hits and
// count_hits: hits_in_order.h. closest_point: of places, not of rays (closest.h).
enum class Query { nearest_hit, occlusion, all_hits, count_hits, closest_point };

// A structure's rule: as a type where it is known when a program is compiled.
using Proven = std::integral_constant<StopRule, StopRule::proven>;
template <class Structure>
MASU_HD constexpr Proven stop_rule(const Structure&) {
  return {};
}

// Whether a search may end once all cells up to t = exit have been visited. `nearest` is the t of the nearest
// hit so far, t_max where there is none.
template <Query query, class Real, class Stop = Proven>
MASU_HD inline bool can_terminate(Real nearest, Real t_max, Real exit, Stop stop = {}) {
  if (query == Query::occlusion || stop == StopRule::first_cell) return nearest < t_max || t_max <= exit;
  return nearest <= exit;
}

// How rays are traced, compiled in: the ray says by which tests (PreparedRay<Real>, WatertightRay<Real>,
// TextbookRay), `kinds` is a set of primitive kinds.
template <class TestRay_, unsigned kinds_>
struct Method {
  using TestRay = TestRay_;
  using Real = typename TestRay::Real;
  static constexpr unsigned kinds = kinds_;
};

// intersect(), shown to counts that record it.
template <unsigned kinds, class TestRay, class Stored, class Counts>
MASU_HD inline bool test_primitive(const SceneView<Stored>& scene, const TestRay& ray,
                                   PrimitiveIndex primitive, const typename TestRay::Real& t_min,
                                   typename TestRay::Real& t, Counts& counts) {
  const SceneRecord<Stored> from{scene, primitive};
  const bool met = intersect<kinds>(scene, ray, primitive, from, t_min, t, counts);
  if constexpr (records_walk<Counts>)
    counts.tested(primitive, met ? t : static_cast<typename TestRay::Real>(INFINITY));
  return met;
}

#ifdef MASU_HOST_AVX2
// Whether a scene's primitives can be tested several at a time: triangles, without any other kind.
template <class M, class Stored>
inline constexpr bool tests_triangles_in_lanes =
    M::kinds == with_triangles&& std::is_same_v<typename M::TestRay, WatertightRay<typename M::Real>> &&
    (sizeof(Stored) <= sizeof(typename M::Real));
#endif

// Keeps the nearest hit beyond t_min: where that lies, it is read when something is met.
template <class M, class Stored, class Counts, class Stop = Proven>
struct NearestHit {
  using Real = typename M::Real;
  static constexpr unsigned kinds = M::kinds;
  const SceneView<Stored>& scene;
  const typename M::TestRay& ray;
  Counts& counts;
  const Real& t_min;
  Real t_max;
  Hit<Real> hit; // at t_max, of primitive 0, where nothing is hit yet: no primitive wins that tie
  Stop stop{};

  MASU_HD void primitive(PrimitiveIndex number) {
    Real t;
    if (test_primitive<M::kinds>(scene, ray, number, t_min, t, counts) && is_nearer(t, number, hit)) {
      hit = {t, number};
      if constexpr (records_walk<Counts>) counts.kept();
    }
  }
  // Of LeafHierarchyView.
  MASU_HD void leaf(const Leaf<Stored>* address) { leaf(fetched(address)); }
  MASU_HD void leaf(const Leaf<Stored>& leaf) {
    const PrimitiveIndex number = leaf.primitive();
    Real t;
    if (intersect<M::kinds>(scene, ray, number, leaf, t_min, t, counts) && is_nearer(t, number, hit))
      hit = {t, number};
  }
  MASU_HD bool done(Real exit) const { return can_terminate<Query::nearest_hit>(hit.t, t_max, exit, stop); }
  // What lies beyond can't be the nearest hit; nor what is still to come, whatever it is.
  MASU_HD Real farthest() const { return hit.t; }
  MASU_HD bool ends() const { return false; }
#ifdef MASU_HOST_AVX2
  void met(Real t, PrimitiveIndex number) requires tests_triangles_in_lanes<M, Stored> {
    if (t > t_min && is_nearer(t, number, hit)) hit = {t, number};
  }
#endif
};

// Ends with the first hit between t_min and t_max, whichever it is.
template <class M, class Stored, class Counts>
struct AnyHit {
  using Real = typename M::Real;
  static constexpr unsigned kinds = M::kinds;
  const SceneView<Stored>& scene;
  const typename M::TestRay& ray;
  Counts& counts;
  const Real& t_min;
  Real t_max;
  Real hit; // t_max where nothing is hit yet

  MASU_HD void primitive(PrimitiveIndex number) {
    Real t;
    if (!found() && test_primitive<M::kinds>(scene, ray, number, t_min, t, counts) && t < t_max) {
      hit = t;
      if constexpr (records_walk<Counts>) counts.kept();
    }
  }
  MASU_HD void leaf(const Leaf<Stored>* address) {
    if (!found()) leaf(fetched(address));
  }
  MASU_HD void leaf(const Leaf<Stored>& leaf) {
    if (found()) return;
    Real t;
    if (intersect<M::kinds>(scene, ray, leaf.primitive(), leaf, t_min, t, counts) && t < t_max) hit = t;
  }
  MASU_HD bool found() const { return hit < t_max; }
  MASU_HD bool done(Real exit) const { return can_terminate<Query::occlusion>(hit, t_max, exit); }
  MASU_HD Real farthest() const { return t_max; }
  MASU_HD bool ends() const { return found(); }
#ifdef MASU_HOST_AVX2
  void met(Real t, PrimitiveIndex) requires tests_triangles_in_lanes<M, Stored> {
    if (t > t_min && t < t_max) hit = t;
  }
#endif
};

// Shows the visitor what is listed for the cell that the ray is in, and goes on to the next; false at the
// end.
template <class Real, class Structure, class Visitor>
MASU_HD inline bool visit_cell(const Structure& grid, Walk<Real, Structure>& walk, Visitor& visitor) {
  walk.enter(grid);
  std::uint32_t next = walk.cell.list;
  visitor.counts.cell(next == empty_list);
  if constexpr (records_walk<std::decay_t<decltype(visitor.counts)>>) visitor.counts.entered(grid, walk);
  PrimitiveIndex ahead = next != empty_list ? grid.references[next] : 0; // references[next]
  while (next != empty_list) {
    const PrimitiveIndex reference = ahead;
    if ((reference & last_bit) != 0) {
      next = empty_list;
    } else {
      ahead = grid.references[++next];
    }
    visitor.primitive(reference & ~last_bit);
  }
  const bool done = visitor.done(walk.exit);
  if constexpr (records_walk<std::decay_t<decltype(visitor.counts)>>) visitor.counts.left(walk, done);
  const Vec3i from = walk.voxel();
  const bool goes_on = walk.leave(grid) & !done; // without a branch: most go on
  if (goes_on) visitor.counts.skipped(walk.voxels_from(from) - 1);
  return goes_on;
}

template <class Structure, class Real, class Visitor>
MASU_HD inline void visit(const Structure& grid, const ClippedRay<Real>& near, std::uint32_t,
                          Visitor& visitor) {
  Walk<Real, Structure> walk(grid, near);
  while (visit_cell(grid, walk, visitor)) {
  }
}
template <class Real, class Visitor>
MASU_HD inline void visit(const NoStructure&, const ClippedRay<Real>&, std::uint32_t primitives,
                          Visitor& visitor) {
  for (std::uint32_t i = 0; i < primitives; ++i)
    visitor.primitive(i);
}

// Through a hierarchy, by the walk that suits it (walks_in_use.h).
template <class Real, class Visitor>
MASU_HD inline void visit(const HierarchyView<Real>& hierarchy, const ClippedRay<Real>& near, std::uint32_t,
                          Visitor& visitor) {
#ifdef MASU_HOST_AVX2
  if constexpr (walks_in_use::nearest_first && !std::decay_t<decltype(visitor.counts)>::is_counted) {
    // Boxes are met in the arithmetic in which the scene is stored, of which they have the margin. That holds
    // for rays in float64, too, of which hits need next to nothing of it: rounding the ray's origin to
    // float32 moves it by u M, to which the distances of planes add their 14 u M: far less than 128.
    using Stored = std::remove_cvref_t<decltype(visitor.scene.triangles->a.x)>;
    NearestFirstWalk<Stored> walk(visitor.ray.origin, bounded_inverse(near));
    while (walk.advance(hierarchy, visitor)) {
    }
    return;
  }
#endif
  walk_hierarchy(hierarchy, near, visitor);
}
template <class Real, class Stored, class Visitor>
MASU_HD inline void visit(const LeafHierarchyView<Real, Stored>& hierarchy, const ClippedRay<Real>& near,
                          std::uint32_t, Visitor& visitor) {
  walk_hierarchy(hierarchy, near, visitor);
}

// A grid, a hierarchy or none, known when it is traced: for what is compared with, not for speed. One kernel
// of each kind serves all of them, and both rules by which a search ends.
enum class StructureForm { none, uniform, merged, hierarchy };

// Hierarchy: HierarchyView, or on a GPU LeafHierarchyView.
template <class Real, class Hierarchy = HierarchyView<Real>>
struct AnyStructure {
  StructureForm form = StructureForm::none;
  StopRule stop = StopRule::proven; // with a grid of cells; anything else is proven
  GridView<Real> uniform{};
  MergedGridView<Real> merged{};
  Hierarchy hierarchy{};
};

inline StructureForm form_of(const StructureRecords& structure) {
  return structure.is_hierarchy ? StructureForm::hierarchy
         : structure.is_merged  ? StructureForm::merged
                                : StructureForm::uniform;
}
template <class Real>
AnyStructure<Real> any_structure(const StructureRecords& structure) {
  AnyStructure<Real> any{form_of(structure)};
  if (any.form == StructureForm::uniform) any.uniform = view_of<Real>(structure);
  if (any.form == StructureForm::merged) any.merged = merged_view_of<Real>(structure);
  if (any.form == StructureForm::hierarchy) any.hierarchy = hierarchy_view_of<Real>(structure);
  return any;
}

template <class View>
inline constexpr bool is_any_structure = false;
template <class Real, class Hierarchy>
inline constexpr bool is_any_structure<AnyStructure<Real, Hierarchy>> = true;

template <class Real, class Hierarchy>
MASU_HD inline StopRule stop_rule(const AnyStructure<Real, Hierarchy>& any) {
  return any.form == StructureForm::hierarchy ? StopRule::proven : any.stop;
}

template <class Real, class Hierarchy, class Visitor>
MASU_HD inline void visit(const AnyStructure<Real, Hierarchy>& any, const ClippedRay<Real>& near,
                          std::uint32_t primitives, Visitor& visitor) {
  switch (any.form) {
  case StructureForm::none:
    return visit(NoStructure{}, near, primitives, visitor);
  case StructureForm::uniform:
    return visit(any.uniform, near, primitives, visitor);
  case StructureForm::merged:
    return visit(any.merged, near, primitives, visitor);
  case StructureForm::hierarchy:
    return visit(any.hierarchy, near, primitives, visitor);
  }
}

// The nearest hit at t_min < t < t_max, as of the ray from where it enters the scene's bounds: there t has
// the most digits. Structure: GridView<Real>, MergedGridView<Real>, HierarchyView<Real>, NoStructure or
// AnyStructure<Real>; M: a Method.
template <class M, class Stored, class Structure, class Counts>
MASU_HD inline NearHit<typename M::TestRay>
nearest_hit_near(const SceneView<Stored>& scene, const Structure& structure, const Ray<typename M::Real>& ray,
                 Counts& counts) {
  using Real = typename M::Real;
  ClippedRay<Real> near{};
  const bool meets_bounds = clip(ray, cast<Real>(scene.clip), near);
  if constexpr (records_walk<Counts>) counts.begun(Query::nearest_hit, ray, meets_bounds, near);
  if (!meets_bounds) return {{}, {ray.t_max, no_primitive}, 0};
  typename M::TestRay test_ray;
  prepare(test_ray, near.ray.origin, near.ray.direction);
  const auto stop = stop_rule(structure);
  NearestHit<M, Stored, Counts, std::decay_t<decltype(stop)>> visitor{
      scene, test_ray, counts, near.ray.t_min, near.ray.t_max, {near.ray.t_max, 0}, stop};
  visit(structure, near, scene.primitive_count(), visitor);
  if (!(visitor.hit.t < near.ray.t_max)) visitor.hit = {ray.t_max, no_primitive};
  return {test_ray, visitor.hit, near.skipped};
}

// The same; the hit's t counts from the ray's own origin.
template <class M, class Stored, class Structure, class Counts>
MASU_HD inline Hit<typename M::Real> nearest_hit(const SceneView<Stored>& scene, const Structure& structure,
                                                 const Ray<typename M::Real>& ray, Counts& counts) {
  return relative_to_origin(nearest_hit_near<M>(scene, structure, ray, counts));
}

// Whether any primitive is hit at t_min < t < t_max.
template <class M, class Stored, class Structure, class Counts>
MASU_HD inline bool is_occluded(const SceneView<Stored>& scene, const Structure& structure,
                                const Ray<typename M::Real>& ray, Counts& counts) {
  using Real = typename M::Real;
  ClippedRay<Real> near{};
  const bool meets_bounds = clip(ray, cast<Real>(scene.clip), near);
  if constexpr (records_walk<Counts>) counts.begun(Query::occlusion, ray, meets_bounds, near);
  if (!meets_bounds) return false;
  typename M::TestRay test_ray;
  prepare(test_ray, near.ray.origin, near.ray.direction);
  AnyHit<M, Stored, Counts> visitor{scene, test_ray, counts, near.ray.t_min, near.ray.t_max, near.ray.t_max};
  visit(structure, near, scene.primitive_count(), visitor);
  return visitor.found();
}

} // namespace masu
