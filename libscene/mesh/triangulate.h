// Triangulation of polygons of any number of vertices, convex or not.
//
// Ear clipping in the polygon's plane, short cuts first, after G. H. Meisters, "Polygons Have Ears", American
// Mathematical Monthly 82(6), 1975. Orientations are exact, and an ear may not touch a vertex on a straight
// edge: so a simple polygon is always covered, without flipped triangles and without slivers. Time is about
// n log n for n vertices; polygons for which it would be more go through a plane sweep instead
// (sweep_triangulation.h), unless they touch themselves.
#pragma once

#include "libscene/mesh/triangle_area.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace masu {

struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles; // vertex indices, oriented as the polygon
  std::uint64_t slivers = 0;                           // triangles without area that were left out
  bool crosses_itself = false;                         // has no proper triangulation: approximated
};

// Every vertex of `polygon` is a corner of some triangle, so that edges shared with other polygons stay
// shared; of equal consecutive vertices the first one. Holes may be connected by a bridge (an edge used in
// both directions). Vertices needn't be exactly coplanar: they are projected along the polygon's mean normal.
// Magnitudes of coordinates must be at most 1e100. Empty when the polygon has no area. The memory of `result`
// is reused. Triangles and convex quadrilaterals have a fast path.
void triangulate(std::span<const Vec3d> polygon, Triangulation& result);

} // namespace masu
