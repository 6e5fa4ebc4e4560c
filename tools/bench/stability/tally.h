// What became of rays, counted.
#pragma once

#include "libscene/geometry/primitives.h"
#include "tools/bench/stability/closest_hit.h"

#include <cstdint>
#include <span>
#include <vector>

namespace masu::stability {

// What a ray found: t in the length of its direction; no_primitive for nothing.
struct Found {
  double t;
  PrimitiveIndex primitive;
  bool same; // by every grid, and without one, to the bit
};

struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t unsure = 0;    // may touch something or not, within what the arithmetic is allowed
  std::uint64_t missed = 0;    // found nothing where something is; a leak
  std::uint64_t false_hit = 0; // found something where nothing is; acne
  std::uint64_t wrong = 0;     // found another primitive than it should
  std::uint64_t misplaced = 0; // found the right one, farther off its place than is allowed
  std::uint64_t by_grid = 0;   // found something else through one grid than through another, or without one
  double worst_t = 0;          // relative error of the t of right hits that aren't in doubt

  std::uint64_t failures() const { return missed + false_hit + wrong + misplaced + by_grid; }
};
Tally& operator+=(Tally& total, const Tally& part);

// Counts what was found against the oracle's closest hits. `slack` is what the arithmetic is allowed, `u` its
// unit roundoff. In parallel over rays.
std::vector<Tally> judged(const oracle::SceneOracle& oracle, std::span<const ListedRay> rays, double slack,
                          double u, std::span<const std::vector<Found>> methods);

// Of rays that begin inside a closed surface: whatever they hit, they hit something.
Tally judged_enclosed(std::span<const Found> found);

} // namespace masu::stability
