// Rays of which two tracers find different primitives, and which of them exact arithmetic says is right.
#pragma once

#include "libscene/geometry/primitives.h"
#include "stability/tally.h"

#include <cstdint>
#include <span>

namespace masu::stability {

// both: different primitives at the same t, such as at a shared edge.
struct Disagreement {
  std::uint64_t rays = 0, differing = 0;
  std::uint64_t first = 0, second = 0, both = 0, neither = 0; // are right, of those that differ
};

// By exact_nearest().
Disagreement disagreement(std::span<const Triangle<float>> triangles, std::span<const Ray<double>> rays,
                          std::span<const Found> first, std::span<const Found> second);

} // namespace masu::stability
