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
  MASU_HD void cell(std::uint32_t list) {
    if (list == empty_list) return counts.empty_cell();
    counts.cell();
    for (bool last = false; !last; ++list) {
      const std::uint32_t reference = references[list];
      last = (reference & last_bit) != 0;
      primitive(reference & ~last_bit);
    }
  }
  MASU_HD void moved(std::int32_t voxels) { counts.skipped(voxels - 1); }
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
  MASU_HD void cell(std::uint32_t list) {
    if (list == empty_list) return counts.empty_cell();
    counts.cell();
    for (bool last = false; !last && !found; ++list) {
      const std::uint32_t reference = references[list];
      last = (reference & last_bit) != 0;
      primitive(reference & ~last_bit);
    }
  }
  MASU_HD void moved(std::int32_t voxels) { counts.skipped(voxels - 1); }
  MASU_HD bool done(Real exit) const { return found || t_max <= exit; }
};

template <class Grid, class Real, class Visitor>
MASU_HD inline void visit(const Grid& grid, const ClippedRay<Real>& near, std::uint32_t, Visitor& visitor) {
  walk(grid, near, visitor);
}
template <class Real, class Visitor>
MASU_HD inline void visit(const NoGrid&, const ClippedRay<Real>&, std::uint32_t primitives,
                          Visitor& visitor) {
  for (std::uint32_t i = 0; i < primitives; ++i)
    visitor.primitive(i);
}

MASU_HD inline const PrimitiveIndex* references_of(const NoGrid&) {
  return nullptr;
}
template <class Grid>
MASU_HD inline const PrimitiveIndex* references_of(const Grid& grid) {
  return grid.references;
}

// The nearest hit at 0 < t < t_max, as of the ray from where it enters the scene's bounds: there t has the
// most digits. Grid: GridView<Real>, MergedGridView<Real> or NoGrid.
template <unsigned kinds, class Real, class Stored, class Grid, class Counts>
MASU_HD inline NearHit<Real> nearest_hit_near(const SceneView<Stored>& scene, const Grid& grid,
                                              const Ray<Real>& ray, Counts& counts) {
  ClippedRay<Real> near{};
  if (!clip(ray, cast<Real>(scene.clip), near)) return {{}, {ray.t_max, no_primitive}, 0};
  const RayFrame<Real> frame = ray_frame(near.ray.origin, near.ray.direction);
  // Primitive 0 at t_max: no primitive wins that tie.
  NearestHit<kinds, Real, Stored, Counts> visitor{
      scene, references_of(grid), frame, counts, {near.ray.t_max, 0}};
  visit(grid, near, scene.primitive_count(), visitor);
  if (!(visitor.hit.t < near.ray.t_max)) visitor.hit = {ray.t_max, no_primitive};
  return {frame, visitor.hit, near.skipped};
}

// The same; the hit's t counts from the ray's own origin.
template <unsigned kinds, class Real, class Stored, class Grid, class Counts>
MASU_HD inline Hit<Real> nearest_hit(const SceneView<Stored>& scene, const Grid& grid, const Ray<Real>& ray,
                                     Counts& counts) {
  return seen_from_origin(nearest_hit_near<kinds>(scene, grid, ray, counts));
}

// Whether any primitive is hit at 0 < t < t_max.
template <unsigned kinds, class Real, class Stored, class Grid, class Counts>
MASU_HD inline bool is_blocked(const SceneView<Stored>& scene, const Grid& grid, const Ray<Real>& ray,
                               Counts& counts) {
  ClippedRay<Real> near{};
  if (!clip(ray, cast<Real>(scene.clip), near)) return false;
  const RayFrame<Real> frame = ray_frame(near.ray.origin, near.ray.direction);
  AnyHit<kinds, Real, Stored, Counts> visitor{scene,  references_of(grid), frame,
                                              counts, near.ray.t_max,      false};
  visit(grid, near, scene.primitive_count(), visitor);
  return visitor.found;
}

} // namespace masu
