// Replaces spheres and cones by triangles, for comparison with ray tracers that only have triangles.
//
// A cone gets `facets` flat sides of two triangles each, or of one at a pointed end. A sphere is a projected
// cube: each face is divided into (facets/4)² squares of equal angles, so that its equator has `facets`
// sides, and each square into two triangles. With 12 facets a cone has 24 triangles and a sphere 108, as in
// the SPD's own programs.
//
// Corners lie on the surface, and neighbours share them bit for bit: there are no gaps. Fronts are outside,
// or inside for negative radii; but triangles are visible from both sides. Corner normals are the surface's,
// for smooth shading. Those of spheres depend only on `facets`, and all spheres share them.
#pragma once

#include "libscene/scene.h"

namespace masu {

inline constexpr int min_facets = 4;
inline constexpr int max_facets = 1024;

// `scene` with triangles only: its own, then the spheres', then the cones', each kind in its order. Objects
// and materials don't change. `facets` is a multiple of 4 from min_facets to max_facets. Throws Error(usage,
// "--tessellate", …) for more than 2^32-2 primitives.
Scene tessellated(Scene scene, int facets);

} // namespace masu
