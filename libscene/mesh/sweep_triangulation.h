// Triangulation of large simple polygons in a plane by a plane sweep, in O(n log n); triangulate.cpp projects
// them.
//
// The sweep divides the polygon into trapezoids, whose diagonals divide it into monotone mountains: polygons
// of a base edge and a chain that is monotone above or below it. Any convex vertex of a chain is an ear.
// After A. Fournier & D. Y. Montuno, "Triangulating Simple Polygons and Equivalent Problems", ACM
// Transactions on Graphics 3(2), 1984, and R. Seidel, "A Simple and Fast Incremental Randomized Algorithm for
// Computing Trapezoidal Decompositions and for Triangulating Polygons", Computational Geometry 1(1), 1991.
// Crossings are found as M. I. Shamos & D. Hoey do, "Geometric Intersection Problems", FOCS 1976.
#pragma once

#include "libscene/geometry/orientation.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace masu {

enum class SweepOutcome {
  triangulated,
  crosses,   // the polygon crosses itself, at a vertex maybe: there is no triangulation
  undecided, // the polygon touches itself, or rounding would leave triangles without area
};

// `ring`: indices of `points`, of positive signed area. Magnitudes of coordinates are at most 1. Where it
// returns `triangulated`, `triangles` has all ring.size() - 2 of them, all of positive orientation; what else
// it has is meaningless.
SweepOutcome triangulate_by_sweep(std::span<const Point2> points, std::span<const std::uint32_t> ring,
                                  std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace masu
