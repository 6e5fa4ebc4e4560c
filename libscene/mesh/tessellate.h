// Triangles in place of spheres and cones, for comparing with tracers that know only triangles.
//
// A cone gets `facets` flat sides, each of two triangles, or of one where it comes to a point. A sphere is a
// cube blown up: each of its faces is divided into (facets/4)² squares of equal angles, so that a ring of
// faces has `facets` sides too, and each square into two triangles. 12 facets make 24 triangles of a cone and
// 108 of a sphere, as the SPD's own programs do.
//
// Corners lie on the surface, and neighbours share them bit for bit: no gaps. Fronts are where the sphere's
// or the cone's are: outside, or inside for negative radii; but a triangle shows both its sides. Corner
// normals are the surface's, so that it looks round. Those of spheres depend on nothing but `facets`, and are
// there once for all.
#pragma once

#include "libscene/scene.h"

namespace masu {

inline constexpr int least_facets = 4;
inline constexpr int most_facets = 1024;

// `scene` with triangles alone: its own, then the spheres', then the cones', each kind in its order. Objects,
// materials and what counts them stay as they are. `facets` is a multiple of 4 from least_facets to
// most_facets. Throws Error(usage, "--tessellate", …) for more than 2^32-2 primitives.
Scene tessellated(Scene scene, int facets);

} // namespace masu
