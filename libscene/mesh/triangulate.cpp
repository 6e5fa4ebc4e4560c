#include "libscene/mesh/triangulate.h"

#include "libscene/mesh/ear_clipping.h"
#include "libscene/mesh/sweep_triangulation.h"

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

int largest_axis(const Vec3d& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return x > y && x > z ? 0 : y > z ? 1 : 2;
}

// The fast path for four vertices: split along the shorter diagonal, if all corners are clearly convex.
bool split_convex_quad(std::span<const Vec3d, 4> q, Triangulation& result) {
  const Vec3d diagonals[2] = {q[2] - q[0], q[3] - q[1]};
  const Vec3d normal = cross(diagonals[0], diagonals[1]);
  const int axis = largest_axis(normal);
  const double facing = normal[axis] < 0 ? -1 : 1;
  double coordinate = 0, edge = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    coordinate = max(coordinate, largest_magnitude(q[i]));
    edge = max(edge, largest_magnitude(q[(i + 1) % 4] - q[i]));
  }
  const double limit = area_error(coordinate, edge);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d turn = cross(q[(i + 1) % 4] - q[i], q[(i + 2) % 4] - q[(i + 1) % 4]);
    if (!(turn[axis] * facing > limit)) return false;
  }
  // Clearly shorter, so that rounding doesn't mix both diagonals in a regular mesh.
  if (dot(diagonals[1], diagonals[1]) < 0.999 * dot(diagonals[0], diagonals[0])) {
    result.triangles.push_back({0, 1, 3});
    result.triangles.push_back({1, 2, 3});
  } else {
    result.triangles.push_back({0, 1, 2});
    result.triangles.push_back({0, 2, 3});
  }
  return true;
}

// A power of two that scales magnitudes to at most 1, exactly.
double scale_to_one(std::span<const Vec3d> polygon) {
  double largest = 0;
  for (const Vec3d& p : polygon)
    largest = max(largest, largest_magnitude(p));
  return largest > 0 ? std::ldexp(1.0, std::min(1000, -std::ilogb(largest) - 1)) : 1;
}

// Newell's mean normal, of any length. If it vanishes though the vertices aren't collinear (a figure eight),
// the largest normal of a corner. Zero when all vertices are collinear.
Vec3d mean_normal(std::span<const Vec3d> polygon, double scale) {
  const Vec3d origin = polygon[0] * scale;
  Vec3d sum{0, 0, 0}, greatest{0, 0, 0};
  double length = 0, farthest = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec3d a = polygon[i] * scale - origin;
    const Vec3d b = polygon[i + 1] * scale - origin;
    const Vec3d corner = cross(a, b);
    sum = sum + corner;
    if (largest_magnitude(corner) > largest_magnitude(greatest)) greatest = corner;
    length += largest_magnitude(b - a);
    farthest = max(farthest, max(largest_magnitude(a), largest_magnitude(b)));
  }
  if (largest_magnitude(sum) > area_error(1, length)) return sum;
  return largest_magnitude(greatest) > area_error(1, farthest) ? greatest : Vec3d{0, 0, 0};
}

// Projects along the normal's largest axis, keeping the orientation.
std::vector<Point2> project(std::span<const Vec3d> polygon, double scale, const Vec3d& normal) {
  const int axis = largest_axis(normal);
  int first = (axis + 1) % 3;
  int second = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(first, second);
  std::vector<Point2> points;
  points.reserve(polygon.size());
  for (const Vec3d& p : polygon)
    points.push_back({p[first] * scale, p[second] * scale});
  return points;
}

// The vertices without those equal to the one before.
std::vector<std::uint32_t> distinct_ring(std::span<const Vec3d> polygon) {
  std::vector<std::uint32_t> ring;
  ring.reserve(polygon.size());
  for (std::uint32_t i = 0; i < polygon.size(); ++i)
    if (ring.empty() || !(polygon[ring.back()] == polygon[i])) ring.push_back(i);
  while (ring.size() > 1 && polygon[ring.back()] == polygon[ring.front()])
    ring.pop_back();
  return ring;
}

// Whether the triangle has an area not by rounding in the projection alone.
bool is_good(std::span<const Vec3d> polygon, const std::array<std::uint32_t, 3>& t) {
  return has_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
}

// Where ear clipping takes too long: by the sweep, whose triangles are longer but which is never slow. False
// where it can't.
bool is_swept(std::span<const Vec3d> polygon, std::span<const Point2> points,
              std::span<const std::uint32_t> ring, Triangulation& result) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const SweepOutcome outcome = triangulate_by_sweep(points, ring, triangles);
  if (outcome == SweepOutcome::crosses) result.crosses_itself = true;
  if (outcome != SweepOutcome::triangulated ||
      !std::ranges::all_of(triangles, [&](const auto& t) { return is_good(polygon, t); }))
    return false;
  result = {std::move(triangles), 0, false};
  return true;
}

} // namespace

void triangulate(std::span<const Vec3d> polygon, Triangulation& result) {
  result.triangles.clear();
  result.slivers = 0;
  result.crosses_itself = false;
  if (polygon.size() < 3) return;
  if (polygon.size() == 3) {
    if (has_area(polygon[0], polygon[1], polygon[2])) result.triangles.push_back({0, 1, 2});
    return;
  }
  if (polygon.size() == 4 && split_convex_quad(polygon.first<4>(), result)) return;

  const double scale = scale_to_one(polygon);
  const Vec3d normal = mean_normal(polygon, scale);
  const std::vector<std::uint32_t> ring = distinct_ring(polygon);
  if (normal == Vec3d{0, 0, 0} || ring.size() < 3) return;
  const std::vector<Point2> points = project(polygon, scale, normal);
  clip_ears(
      points, ring, [&] { return is_swept(polygon, points, ring, result); }, result);
  result.slivers += std::erase_if(result.triangles, [&](const auto& t) { return !is_good(polygon, t); });
}

} // namespace masu
