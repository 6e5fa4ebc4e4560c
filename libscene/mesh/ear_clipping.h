// Ear clipping of a polygon in a plane; triangulate.cpp projects it.
#pragma once

#include "libscene/geometry/orientation.h"
#include "libscene/mesh/triangulate.h"

#include <functional>
#include <span>

namespace masu {

// Appends triangles of the polygon `ring`: indices of `points`, of positive signed area; no two neighbours
// are the same point. Magnitudes of coordinates are at most 1.
//
// Where finding out whether ears contain other vertices takes too many steps, about so many that n log n of
// them are enough for most polygons, otherwise() is called: true ends it. Else ear clipping goes on; not
// testing ears any more where the result crosses itself, and so none could be right.
void clip_ears(std::span<const Point2> points, std::span<const std::uint32_t> ring,
               const std::function<bool()>& otherwise, Triangulation& result);

} // namespace masu
