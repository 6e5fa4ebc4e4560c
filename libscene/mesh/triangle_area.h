// Whether a triangle has an area, or one by rounding alone; and whether a face of a mesh can be hit.
#pragma once

#include "libscene/geometry/vector.h"

namespace masu {

// The error of a cross product's components when coordinates up to m were rounded to doubles: a difference of
// them is off by up to 2um, a component of the product of two such edges no longer than l by up to 8uml.
MASU_HD inline double area_error(double largest_coordinate, double longest_edge) {
  return 8 * RealTraits<double>::unit_roundoff * largest_coordinate * longest_edge;
}

// False for a triangle no higher than the rounding error of its corners' decimal coordinates.
MASU_HD inline bool has_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d to_b = b - a;
  const Vec3d to_c = c - a;
  const double coordinate = max(largest_magnitude(a), max(largest_magnitude(b), largest_magnitude(c)));
  const double edge = max(largest_magnitude(to_b), largest_magnitude(to_c));
  return largest_magnitude(cross(to_b, to_c)) > area_error(coordinate, edge);
}

// Of a mesh's face, whether it can be hit: no two of its corners are one point. Three on a line may be: where
// tessellators split an edge of one face, but not of its neighbour, they fill the gap with such a face. Seen
// along a ray, corners move by a rounding, and the gap opens by as much; the face then covers just that.
MASU_HD inline bool has_distinct_corners(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return !(a == b) && !(b == c) && !(c == a);
}

// Triangles that nothing can hit keep the numbers of a mesh's faces of which two corners coincide. Such a
// face isn't stored as it is: far from the others it would enlarge the scene's bounds, and with them every
// error bound. All three corners of its triangle are one point instead (has_surface, primitives.h), a corner
// of the first one that has a surface, which no test hits, and which builders leave out. Where none has one,
// it is this point.
inline constexpr Vec3d points_without_surface{1, 1, 1};

} // namespace masu
