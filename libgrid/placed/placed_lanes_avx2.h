// What walks of several rays at a time through placed meshes ask for (libgrid/hierarchy/walk: EightWalks,
// PacketWalk), on a processor with AVX2: they go as PlacedWalk does (placed_walk.h). Host only.
#pragma once

#include "libgrid/hierarchy/walk/boxes_avx2.h"
#include "libgrid/placed/placed_walk.h"

namespace masu {

// Nodes ahead of a walk that has none in groups: those above, those of a mesh, and the second root.
inline constexpr int max_placed_ahead = (boxes_per_node - 1) * (max_upper_levels + max_hierarchy_depth) + 1;

template <class Real>
MASU_ALWAYS_INLINE Real select(bool where, Real a, Real b) {
  return where ? a : b;
}

// An inverse direction, as bounded_inverse() has it.
template <class Number>
MASU_ALWAYS_INLINE Vec3<Number> bounded(const Vec3<Number>& inverse) {
  const Number limit = 0x1p64F;
  const auto along = [&](Number v) { return min(max(v, -limit), limit); };
  return {along(inverse.x), along(inverse.y), along(inverse.z)};
}

// A ray in boxes' space, or several: the origins with which it meets the planes by which it enters and leaves
// boxes, and its direction's inverse, bounded.
template <class Number>
struct BoundRay {
  Vec3<Number> entering, leaving, inverse;
};
// Carried into a placement's mesh. To have planes moved outwards the origin is moved: against them.
template <class Number, class Placed>
MASU_ALWAYS_INLINE BoundRay<Number> carried_ray(const Placed& placement, const Vec3<Number>& origin,
                                                const Vec3<Number>& direction) {
  const Number outwards = placement.padding;
  const Vec3<Number> from = carried_point(placement, origin), along = carried(placement, direction);
  const Vec3<Number> inverse =
      bounded<Number>({finite_inverse(along.x), finite_inverse(along.y), finite_inverse(along.z)});
  const auto moved = [&](Number v) { return select(v < Number(0), -outwards, outwards); };
  const Vec3<Number> move{moved(inverse.x), moved(inverse.y), moved(inverse.z)};
  return {from + move, from - move, inverse};
}

} // namespace masu
