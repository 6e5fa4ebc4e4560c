// What walks of several rays at a time through placed meshes ask for (libgrid/hierarchy/walk: EightWalks,
// PacketWalk), on a processor with AVX2: they go as PlacedWalk does (placed_walk.h). Host only.
#pragma once

#include "libgrid/hierarchy/walk/boxes_avx2.h"
#include "libgrid/placed/placed_walk.h"

namespace masu {

// Nodes ahead of a walk that has none in groups: those above, those of a mesh, and the second root.
inline constexpr int max_placed_ahead = (boxes_per_node - 1) * (max_upper_levels + max_hierarchy_depth) + 1;

// A ray in boxes' space, or several, in lanes or as vectors of lanes: the origins with which it meets the
// planes by which it enters and leaves boxes, and its direction's inverse, bounded as bounded_inverse() has
// it.
template <class Numbers>
struct BoundRay {
  Numbers entering, leaving, inverse;
};
template <class Real>
MASU_ALWAYS_INLINE Lanes<Real> bounded(Lanes<Real> inverse) {
  const Lanes<Real> limit = Real(0x1p64F);
  return min(max(inverse, -limit), limit);
}
template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> bounded(const Vec3<Lanes<Real>>& inverse) {
  return {bounded(inverse.x), bounded(inverse.y), bounded(inverse.z)};
}
// To have planes moved outwards the origin is moved: against them.
template <class Real>
MASU_ALWAYS_INLINE BoundRay<Lanes<Real>> bound_ray(Lanes<Real> from, Lanes<Real> direction, Real outwards) {
  const Lanes<Real> inverse = bounded(finite_inverse(direction)),
                    move = select(inverse < Lanes<Real>(0), Lanes<Real>(-outwards), Lanes<Real>(outwards));
  return {from + move, from - move, inverse};
}

// Carried into a placement's mesh, as many rays as lanes.
template <class Real, class Placed>
MASU_ALWAYS_INLINE BoundRay<Vec3<Lanes<Real>>>
carried_rays(const Placed& placement, const Vec3<Lanes<Real>>& origin, const Vec3<Lanes<Real>>& direction) {
  const Vec3<Lanes<Real>> from = carried_point(placement, origin), along = carried(placement, direction);
  const Real outwards = placement.padding;
  const auto x = bound_ray(from.x, along.x, outwards), y = bound_ray(from.y, along.y, outwards),
             z = bound_ray(from.z, along.z, outwards);
  return {{x.entering, y.entering, z.entering},
          {x.leaving, y.leaving, z.leaving},
          {x.inverse, y.inverse, z.inverse}};
}

// One ray, as axes_of() has it.
template <class Real, class Placed>
MASU_ALWAYS_INLINE BoundRay<Lanes<Real>> carried_ray(const Placed& placement, const Vec3<Real>& origin,
                                                     const Vec3<Real>& direction) {
  const auto& rows = placement.inverse;
  const auto column = [&](int j) {
    return axes_of<Real>(Vec3<Real>{Real(rows[0][j]), Real(rows[1][j]), Real(rows[2][j])});
  };
  const Lanes<Real> x = column(0), y = column(1), z = column(2);
  const auto by_columns = [&](const Vec3<Real>& v) { return fma(x, v.x, fma(y, v.y, z * Lanes<Real>(v.z))); };
  return bound_ray(by_columns(origin - cast<Real>(placement.translation())), by_columns(direction),
                   Real(placement.padding));
}

} // namespace masu
