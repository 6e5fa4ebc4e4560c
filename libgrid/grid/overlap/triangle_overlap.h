// Whether boxes meet a triangle.
#pragma once

#include "libscene/geometry/primitives.h"

#include <algorithm>

namespace masu {

// The axis that a triangle faces most, by its normal.
MASU_HD inline int facing_axis(const Vec3d& normal) {
  const Vec3d steep{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  return steep.x >= steep.y && steep.x >= steep.z ? 0 : steep.y >= steep.z ? 1 : 2;
}
MASU_HD inline Vec3d plane_normal(const Triangle<double>& triangle) {
  return cross(triangle.b - triangle.a, triangle.c - triangle.b);
}

// Triangle and box by separating axes, after Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", JGT
// 6(1), 2001, with what is the same for every voxel computed apart, as Schwarz & Seidel, "Fast Parallel
// Surface and Solid Voxelization on GPUs", 2010, do: an axis leaves an interval in which the voxel's centre
// must lie. `half` is half the voxel's size, margin included.

// The axis across the triangle's plane: low ≤ normal · center ≤ high.
struct PlaneAxis {
  Vec3d normal;
  double low, high;

  MASU_HD bool leaves(const Vec3d& center) const {
    const double at = dot(normal, center);
    return at >= low && at <= high;
  }
};

MASU_HD inline PlaneAxis plane_axis(const Triangle<double>& triangle, const Vec3d& half) {
  const Vec3d normal = plane_normal(triangle);
  const Vec3d steep{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  // A needle's normal is mostly rounding error: how far that moves the plane within the voxels it meets is
  // added.
  const double side1 = length(triangle.b - triangle.a), side2 = length(triangle.c - triangle.b);
  const double reach = side1 + side2 + length(half) * 2;
  const double rounding = 16 * RealTraits<double>::unit_roundoff * side1 * side2 * reach;
  const double offset = dot(normal, triangle.a), radius = dot(steep, half) + rounding;
  return {normal, offset - radius, offset + radius};
}

// The axis edge × unit vector of `dropped`, as a line in the plane of the other two axes: low ≤ u·center[i] +
// v·center[j] ≤ high.
struct EdgeAxis {
  double u, v, low, high;

  MASU_HD bool leaves(double i, double j) const {
    const double at = u * i + v * j;
    return at >= low && at <= high;
  }
};

MASU_HD inline EdgeAxis edge_axis(const Triangle<double>& triangle, const Vec3d& half, int dropped,
                                  int edge) {
  const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  const Vec3d from = edge == 0 ? triangle.a : edge == 1 ? triangle.b : triangle.c;
  const Vec3d to = edge == 0 ? triangle.b : edge == 1 ? triangle.c : triangle.a;
  const Vec3d opposite = edge == 0 ? triangle.c : edge == 1 ? triangle.a : triangle.b;
  const Vec3d along = to - from;
  const double u = -along[j], v = along[i];
  const auto at = [&](const Vec3d& corner) { return u * corner[i] + v * corner[j]; };
  // Two corners lie on the edge itself, and are as good as one.
  const double on = at(from), off = at(opposite);
  const double radius = std::abs(u) * half[i] + std::abs(v) * half[j];
  return {u, v, std::min(on, off) - radius, std::max(on, off) + radius};
}

// A triangle against many voxels of one size.
class TriangleOverlap {
public:
  MASU_HD TriangleOverlap(const Triangle<double>& triangle, const Vec3d& half)
      : plane_(plane_axis(triangle, half)), facing_(facing_axis(plane_.normal)) {
    for (int dropped = 0; dropped < 3; ++dropped)
      for (int edge = 0; edge < 3; ++edge)
        edges_[dropped][edge] = edge_axis(triangle, half, dropped, edge);
  }

  // Where along facing_axis() the centres of a column's voxels may lie, for the column through `center`
  // (whose coordinate along that axis doesn't matter). False when the column passes the triangle by.
  MASU_HD bool column(const Vec3d& center, double& low, double& high) const {
    const int w = facing_, u = (w + 1) % 3, v = (w + 2) % 3;
    for (const EdgeAxis& axis : edges_[w]) {
      if (!axis.leaves(center[u], center[v])) return false;
    }
    // low ≤ normal · center ≤ high, solved for the coordinate along w.
    const Vec3d& normal = plane_.normal;
    const double rest = normal[u] * center[u] + normal[v] * center[v];
    const double one = (plane_.low - rest) / normal[w], other = (plane_.high - rest) / normal[w];
    low = std::min(one, other);
    high = std::max(one, other);
    // A triangle without area has no plane: every voxel of the column is looked at.
    if (normal[w] == 0) {
      low = -RealTraits<double>::largest;
      high = RealTraits<double>::largest;
    }
    return true;
  }

  // Whether the voxel about `center` meets the triangle, given that its column and its bounding box do.
  MASU_HD bool meets(const Vec3d& center) const {
    if (!plane_.leaves(center)) return false;
    for (int dropped = 0; dropped < 3; ++dropped) {
      if (dropped == facing_) continue;
      const double i = center[(dropped + 1) % 3], j = center[(dropped + 2) % 3];
      for (const EdgeAxis& axis : edges_[dropped]) {
        if (!axis.leaves(i, j)) return false;
      }
    }
    return true;
  }

private:
  PlaneAxis plane_;
  EdgeAxis edges_[3][3]; // [dropped axis][edge]
  int facing_;
};

// Whether the box meets the triangle, thickened by margin on both sides, given that their bounding boxes
// meet. `voxel` is not grown.
MASU_HD inline bool meets(const Triangle<double>& triangle, const Boxd& voxel, double margin) {
  const Vec3d half = (voxel.max - voxel.min) * 0.5 + Vec3d{margin, margin, margin};
  const Vec3d center = (voxel.min + voxel.max) * 0.5;
  if (!plane_axis(triangle, half).leaves(center)) return false;
  for (int dropped = 0; dropped < 3; ++dropped) {
    for (int edge = 0; edge < 3; ++edge) {
      if (!edge_axis(triangle, half, dropped, edge)
               .leaves(center[(dropped + 1) % 3], center[(dropped + 2) % 3]))
        return false;
    }
  }
  return true;
}

} // namespace masu
