// Counts of correct and wrong results.
#pragma once

#include "libscene/geometry/primitives.h"
#include "stability/oracle/closest_hit.h"

#include <cstdint>
#include <span>
#include <vector>

namespace masu::stability {

// A ray's hit: t in lengths of its direction; no_primitive for a miss.
struct Found {
  double t;
  PrimitiveIndex primitive;
  bool same; // bit-identical through every grid and without one
};

struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t unsure = 0;    // more than one result is admissible within the error bound
  std::uint64_t missed = 0;    // no hit where there is one: a leak
  std::uint64_t false_hit = 0; // a hit where there is none: acne
  std::uint64_t wrong = 0;     // a hit of a wrong primitive
  std::uint64_t misplaced = 0; // a hit of the right primitive, at a t beyond the error bound
  std::uint64_t by_grid = 0;   // the result depends on the grid
  double worst_t = 0;          // largest relative error of t of correct hits that are sure

  std::uint64_t failures() const { return missed + false_hit + wrong + misplaced + by_grid; }
};
Tally& operator+=(Tally& total, const Tally& part);

// Compares hits with the oracle's closest hits, one tally for each of `methods`. `slack` is the error bound
// of the arithmetic, `u` its unit roundoff. Parallel over rays.
std::vector<Tally> judged(const oracle::SceneOracle& oracle, std::span<const Ray<double>> rays, double slack,
                          double u, std::span<const std::vector<Found>> methods);

// For rays that begin inside a closed surface, which must hit something.
Tally judged_enclosed(std::span<const Found> found);

} // namespace masu::stability
