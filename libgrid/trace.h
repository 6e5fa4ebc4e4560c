// The nearest hit of a ray, and whether anything blocks it: through a grid, or without one by trying every
// primitive. Either way the same bits come out.
#pragma once

#include "libgrid/walk.h"
#include "libscene/clip.h"
#include "libscene/intersect.h"

namespace masu {

// In a grid's place: every primitive is tried.
struct NoGrid {};

// Keeps the nearest hit.
template <unsigned kinds, class Real, class Stored, class Counts>
struct NearestHit {
  const SceneView<Stored>& scene;
  const PrimitiveIndex* references;
  const RayFrame<Real>& ray;
  Counts& counts;
  Hit<Real> hit;

  MASU_HD void primitive(PrimitiveIndex number) {
    Real t;
    if (intersect<kinds>(scene, ray, number, t, counts) && is_nearer(t, number, hit)) hit = {t, number};
  }
  MASU_HD void cell(std::uint32_t first, std::uint32_t last) {
    counts.cell();
    for (std::uint32_t i = first; i < last; ++i)
      primitive(references[i]);
  }
  MASU_HD void empty_cell(std::uint64_t skipped) { counts.empty_cell(skipped); }
  MASU_HD bool done(Real exit) const { return hit.t <= exit; }
};

// Ends with the first hit nearer than t_max, whichever it is.
template <unsigned kinds, class Real, class Stored, class Counts>
struct AnyHit {
  const SceneView<Stored>& scene;
  const PrimitiveIndex* references;
  const RayFrame<Real>& ray;
  Counts& counts;
  Real t_max;
  bool found;

  MASU_HD void primitive(PrimitiveIndex number) {
    Real t;
    found = found || (intersect<kinds>(scene, ray, number, t, counts) && t < t_max);
  }
  MASU_HD void cell(std::uint32_t first, std::uint32_t last) {
    counts.cell();
    for (std::uint32_t i = first; i < last && !found; ++i)
      primitive(references[i]);
  }
  MASU_HD void empty_cell(std::uint64_t skipped) { counts.empty_cell(skipped); }
  MASU_HD bool done(Real exit) const { return found || t_max <= exit; }
};

template <class Real, class Visitor>
MASU_HD inline void visit(const GridView<Real>& grid, const Ray<Real>& ray, std::uint32_t, Visitor& visitor) {
  walk(grid, ray.origin, ray.direction, visitor);
}
template <class Real, class Visitor>
MASU_HD inline void visit(const NoGrid&, const Ray<Real>&, std::uint32_t primitives, Visitor& visitor) {
  for (std::uint32_t i = 0; i < primitives; ++i)
    visitor.primitive(i);
}

MASU_HD inline const PrimitiveIndex* references_of(const NoGrid&) {
  return nullptr;
}
template <class Real>
MASU_HD inline const PrimitiveIndex* references_of(const GridView<Real>& grid) {
  return grid.references;
}

// The nearest hit at 0 < t < t_max. Grid: GridView<Real> or NoGrid. The hit's t counts from the ray's own
// origin.
template <unsigned kinds, class Real, class Stored, class Grid, class Counts>
MASU_HD inline Hit<Real> nearest_hit(const SceneView<Stored>& scene, const Grid& grid, const Ray<Real>& ray,
                                     Counts& counts) {
  ClippedRay<Real> clipped{};
  if (!clip(ray, cast<Real>(scene.clip), clipped)) return {ray.t_max, no_primitive};
  const RayFrame<Real> frame = ray_frame(clipped.ray.origin, clipped.ray.direction);
  // Primitive 0 at t_max: no primitive wins that tie.
  NearestHit<kinds, Real, Stored, Counts> visitor{
      scene, references_of(grid), frame, counts, {clipped.ray.t_max, 0}};
  visit(grid, clipped.ray, scene.primitive_count(), visitor);
  if (!(visitor.hit.t < clipped.ray.t_max)) return {ray.t_max, no_primitive};
  return {visitor.hit.t + clipped.skipped, visitor.hit.primitive};
}

// Whether any primitive is hit at 0 < t < t_max.
template <unsigned kinds, class Real, class Stored, class Grid, class Counts>
MASU_HD inline bool is_blocked(const SceneView<Stored>& scene, const Grid& grid, const Ray<Real>& ray,
                               Counts& counts) {
  ClippedRay<Real> clipped{};
  if (!clip(ray, cast<Real>(scene.clip), clipped)) return false;
  const RayFrame<Real> frame = ray_frame(clipped.ray.origin, clipped.ray.direction);
  AnyHit<kinds, Real, Stored, Counts> visitor{scene,  references_of(grid), frame,
                                              counts, clipped.ray.t_max,   false};
  visit(grid, clipped.ray, scene.primitive_count(), visitor);
  return visitor.found;
}

} // namespace masu
