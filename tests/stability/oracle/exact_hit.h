// The nearest hit of a ray among triangles in exact rational arithmetic (GMP), by none of the tracer's
// formulas: who is right where two tracers differ.
#pragma once

#include "libscene/geometry/primitives.h"
#include "libscene/geometry/ray.h"

#include <span>
#include <vector>

namespace masu::stability {

// Whether this program was built with GMP. Without it exact_nearest() throws Error(usage).
extern const bool exact_hits_available;

// All triangles that the ray meets at its smallest t > 0, in ascending order: the first wins the tie. None
// for a miss. Edges and corners belong to a triangle; one that is seen edge-on isn't met.
std::vector<PrimitiveIndex> exact_nearest(std::span<const Triangle<float>> triangles, const Ray<double>& ray);

} // namespace masu::stability
