// Which voxels a primitive is listed in. Two tests, both for closed voxels (touching counts), grown by the
// layout's margin:
//  - box: the primitive's bounding box meets the voxel; a cone's box is taken with the larger radius round
//    both ends.
//  - exact: its surface meets the voxel: the triangle; the sphere's shell; the cone's side.
// Everything is computed in double.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/grid/overlap/cone_overlap.h"
#include "libgrid/grid/overlap/triangle_overlap.h"

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
MASU_HD inline VoxelRows overlap_rows(const GridLayout& layout, Overlap overlap,
                                      const Triangle<double>& triangle) {
  if (!has_surface(triangle)) return {{{0, 0, 0}, {0, 0, -1}}, 0}; // none
  const VoxelRange range = voxels_met(layout, grown(bounds(triangle), layout.margin));
  const bool all = overlap == Overlap::box || is_line(range);
  return {range, all ? 0 : facing_axis(plane_normal(triangle))};
}
// Spheres' and cones'.
template <class Primitive>
MASU_HD VoxelRows overlap_rows(const GridLayout& layout, Overlap overlap, const Primitive& primitive) {
  const Boxd box = overlap == Overlap::box ? box_for_overlap(primitive) : bounds(primitive);
  return {voxels_met(layout, grown(box, layout.margin)), 0};
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

// Of all rows.
template <class Primitive, class Emit>
MASU_HD void for_each_overlap(const GridLayout& layout, Overlap overlap, const Primitive& primitive,
                              const Emit& emit) {
  const VoxelRows rows = overlap_rows(layout, overlap, primitive);
  for_each_overlap(layout, overlap, primitive, rows, 0, rows.count(), emit);
}

} // namespace masu
