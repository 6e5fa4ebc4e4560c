// Which voxels a primitive is listed in. Two tests, both for closed voxels (touching counts), grown by the
// layout's margin:
//  - box: the primitive's bounding box meets the voxel; a cone's box is taken with the larger radius round
//    both ends.
//  - exact: its surface meets the voxel: the triangle; the sphere's shell; the cone's side.
// Everything is computed in double.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/grid/overlap/cone_overlap.h"

#include <type_traits>

namespace masu {

enum class Overlap { box, exact };

MASU_HD inline Boxd box_for_overlap(const Triangle<double>& triangle) {
  return bounds(triangle);
}
MASU_HD inline Boxd box_for_overlap(const Sphere<double>& sphere) {
  return bounds(sphere);
}
MASU_HD inline Boxd box_for_overlap(const Cone<double>& cone) {
  const double radius = std::max(std::abs(cone.base_radius), std::abs(cone.apex_radius));
  return grown(join(Boxd{cone.base, cone.base}, cone.apex), radius);
}

// Whether the box meets the sphere's shell, thickened by margin on both sides. `voxel` is not grown.
MASU_HD inline bool meets(const Sphere<double>& sphere, const Boxd& voxel, double margin) {
  double nearest = 0, farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = voxel.min[axis] - sphere.center[axis], above = sphere.center[axis] - voxel.max[axis];
    const double gap = std::max(0.0, std::max(below, above));
    const double far = std::max(std::abs(below), std::abs(above));
    nearest += gap * gap;
    farthest += far * far;
  }
  const double radius = std::abs(sphere.radius);
  const double outer = radius + margin, inner = std::max(0.0, radius - margin);
  return nearest <= outer * outer && farthest >= inner * inner;
}

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

template <class Emit>
MASU_HD void for_each_voxel(const VoxelRange& range, const Emit& emit) {
  for (std::int32_t z = range.first.z; z <= range.last.z; ++z)
    for (std::int32_t y = range.first.y; y <= range.last.y; ++y)
      for (std::int32_t x = range.first.x; x <= range.last.x; ++x)
        emit(Vec3i{x, y, z});
}

// A connected primitive whose box meets just a line of voxels meets each of them.
MASU_HD inline bool is_line(const VoxelRange& range) {
  const int thick =
      (range.first.x != range.last.x) + (range.first.y != range.last.y) + (range.first.z != range.last.z);
  return thick <= 1;
}

// The voxels that a primitive's bounds meet, as rows along an axis w, numbered along u, then v: threads can
// share them.
struct VoxelRows {
  VoxelRange range;
  int w, u, v;

  MASU_HD VoxelRows(const VoxelRange& voxels, int along)
      : range(voxels), w(along), u((along + 1) % 3), v((along + 2) % 3) {}

  MASU_HD std::uint64_t count() const {
    return width() * (static_cast<std::uint64_t>(range.last[v] - range.first[v]) + 1);
  }
  // act(i, j): the places along u and v of rows first … end - 1.
  template <class Act>
  MASU_HD void for_each(std::uint64_t first, std::uint64_t end, const Act& act) const {
    std::int32_t i = range.first[u] + static_cast<std::int32_t>(first % width());
    std::int32_t j = range.first[v] + static_cast<std::int32_t>(first / width());
    for (std::uint64_t row = first; row < end; ++row) {
      act(i, j);
      if (i != range.last[u]) {
        ++i;
        continue;
      }
      i = range.first[u];
      ++j;
    }
  }
  MASU_HD Vec3i voxel(std::int32_t i, std::int32_t j, std::int32_t k) const {
    Vec3i at{};
    at.set(u, i);
    at.set(v, j);
    at.set(w, k);
    return at;
  }

private:
  MASU_HD std::uint64_t width() const {
    return static_cast<std::uint64_t>(range.last[u] - range.first[u]) + 1;
  }
};

// A triangle's rows run along the axis that it faces: they hold few voxels of it each, however large it is.
template <class Primitive>
MASU_HD VoxelRows overlap_rows(const GridLayout& layout, Overlap overlap, const Primitive& primitive) {
  if (!has_surface(primitive)) return {{{0, 0, 0}, {0, 0, -1}}, 0}; // none
  const Boxd box = overlap == Overlap::box ? box_for_overlap(primitive) : bounds(primitive);
  const VoxelRange range = voxels_met(layout, voxel_size(layout), grown(box, layout.margin));
  if constexpr (std::is_same_v<Primitive, Triangle<double>>)
    if (overlap == Overlap::exact && !is_line(range)) return {range, facing_axis(plane_normal(primitive))};
  return {range, 0};
}

// Calls emit(voxel) once for each voxel of rows first … end - 1 that the primitive is listed in.
template <class Emit>
MASU_HD void for_each_overlap(const GridLayout& layout, Overlap overlap, const Triangle<double>& triangle,
                              const VoxelRows& rows, std::uint64_t first, std::uint64_t end,
                              const Emit& emit) {
  const int w = rows.w;
  if (overlap == Overlap::box || is_line(rows.range)) {
    rows.for_each(first, end, [&](std::int32_t i, std::int32_t j) {
      for (std::int32_t k = rows.range.first[w]; k <= rows.range.last[w]; ++k)
        emit(rows.voxel(i, j, k));
    });
    return;
  }
  const Vec3d size = voxel_size(layout);
  const TriangleOverlap test(triangle, size * 0.5 + Vec3d{layout.margin, layout.margin, layout.margin});
  const auto center = [&](int axis, std::int32_t voxel) {
    return layout.space.min[axis] + (voxel + 0.5) * size[axis];
  };
  rows.for_each(first, end, [&](std::int32_t i, std::int32_t j) {
    Vec3d at{};
    at.set(rows.u, center(rows.u, i));
    at.set(rows.v, center(rows.v, j));
    double low, high;
    if (!test.column(at, low, high)) return;
    const auto voxel_below = [&](double coordinate) {
      return (coordinate - layout.space.min[w]) / size[w] - 0.5;
    };
    // The interval bounds voxel centres. One voxel more on either side allows for its rounding; meets()
    // decides.
    const double from = std::max(std::floor(voxel_below(low)), static_cast<double>(rows.range.first[w]));
    const double to = std::min(std::ceil(voxel_below(high)), static_cast<double>(rows.range.last[w]));
    if (!(from <= to)) return;
    for (std::int32_t k = static_cast<std::int32_t>(from); k <= to; ++k) {
      at.set(w, center(w, k));
      if (test.meets(at)) emit(rows.voxel(i, j, k));
    }
  });
}

// Spheres and cones.
template <class Primitive, class Emit>
MASU_HD void for_each_overlap(const GridLayout& layout, Overlap overlap, const Primitive& primitive,
                              const VoxelRows& rows, std::uint64_t first, std::uint64_t end,
                              const Emit& emit) {
  const Vec3d size = voxel_size(layout);
  rows.for_each(first, end, [&](std::int32_t i, std::int32_t j) {
    for (std::int32_t k = rows.range.first[rows.w]; k <= rows.range.last[rows.w]; ++k) {
      const Vec3i voxel = rows.voxel(i, j, k);
      const Vec3d low = layout.space.min + cast<double>(voxel) * size;
      if (overlap == Overlap::box || meets(primitive, Boxd{low, low + size}, layout.margin)) emit(voxel);
    }
  });
}

} // namespace masu
