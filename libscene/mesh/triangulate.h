// Triangles of a polygon of any vertex count, concave ones too.
//
// Ears are cut off in the polygon's own plane, short cuts first, as G. H. Meisters proved possible
// ("Polygons Have Ears", American Mathematical Monthly 82(6), 1975). Signs are exact, and a vertex on a
// straight edge counts as one that ears must leave outside: so a simple polygon is always covered, without
// flipped triangles and without slivers. Time is about n log n for n vertices, n² in the worst case.
#pragma once

#include "libscene/geometry/vector.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace masu {

struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles; // vertex numbers; each turns as the polygon does
  std::uint64_t slivers = 0;   // vertices that only a triangle without area could have used: left out
  bool crosses_itself = false; // no triangulation covers it properly: covered as well as can be
};

// Every vertex of `polygon` stays a triangle's corner, so that edges shared with neighbours stay shared; of
// vertices that repeat the one before, the first does. Holes may be cut in by a bridge (an edge walked both
// ways). Vertices may stray from a plane a little: they are seen along the polygon's mean normal.
// Coordinates' magnitudes must be at most 1e100. Empty when the polygon has no area.
Triangulation triangulate(std::span<const Vec3d> polygon);

// The same into `result`, whose memory is used again. Triangles and convex quadrilaterals take a short way.
void triangulate(std::span<const Vec3d> polygon, Triangulation& result);

// False for a triangle no higher than the error its corners can have had when their digits became doubles.
bool has_area(const Vec3d& a, const Vec3d& b, const Vec3d& c);

} // namespace masu
