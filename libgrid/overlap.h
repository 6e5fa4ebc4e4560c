// Which voxels a primitive is listed in. Two tests, both for closed voxels (touching counts), grown by the
// lattice's margin:
//  - box: the primitive's bounding box meets the voxel; a cone's box is taken with the larger radius round
//    both ends.
//  - exact: its surface meets the voxel: the triangle; the sphere's shell; the cone's side.
// Everything is computed in double.
#pragma once

#include "libgrid/lattice.h"
#include "libscene/cone.h"
#include "libscene/primitives.h"

namespace masu {

enum class Overlap { box, exact };

inline Boxd box_for_overlap(const Triangle<double>& triangle) {
  return bounds(triangle);
}
inline Boxd box_for_overlap(const Sphere<double>& sphere) {
  return bounds(sphere);
}
inline Boxd box_for_overlap(const Cone<double>& cone) {
  const double radius = std::max(std::abs(cone.base_radius), std::abs(cone.apex_radius));
  return grown(join(Boxd{cone.base, cone.base}, cone.apex), radius);
}

// Triangle and box by separating axes, after Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", JGT
// 6(1), 2001, with all that is the same for every voxel computed once, as Schwarz & Seidel, "Fast Parallel
// Surface and Solid Voxelization on GPUs", 2010, do: an axis leaves an interval in which the voxel's centre
// must lie.
class TriangleOverlap {
public:
  // half: half the voxel's size, margin included.
  TriangleOverlap(const Triangle<double>& triangle, const Vec3d& half);

  // The axis that the triangle faces most.
  int facing() const { return facing_; }

  // Where along facing() the centres of a column's voxels may lie, for the column through `center` (whose
  // coordinate along facing() doesn't matter). False when the column passes the triangle by.
  bool column(const Vec3d& center, double& low, double& high) const;

  // Whether the voxel about `center` meets the triangle, given that its column and its bounding box do.
  bool meets(const Vec3d& center) const;

private:
  // The axis edge × unit vector of `dropped`, as a line in the plane of the other two axes: low ≤ u·center[i]
  // + v·center[j] ≤ high.
  struct EdgeAxis {
    double u, v, low, high;
  };
  static bool within(const EdgeAxis& axis, double i, double j) {
    const double at = axis.u * i + axis.v * j;
    return at >= axis.low && at <= axis.high;
  }

  Vec3d normal_{};
  double plane_low_, plane_high_; // interval of normal · center
  EdgeAxis axes_[3][3];           // [dropped axis][edge]
  int facing_;
};

// Whether the box meets the triangle, thickened by margin on both sides. `voxel` is not grown.
bool meets(const Triangle<double>& triangle, const Boxd& voxel, double margin);

// Whether the box meets the sphere's shell, thickened by margin on both sides. `voxel` is not grown.
bool meets(const Sphere<double>& sphere, const Boxd& voxel, double margin);

// Whether the box meets the cone's side, thickened by margin. `voxel` is not grown.
bool meets(const Cone<double>& cone, const Boxd& voxel, double margin);

template <class Emit>
void for_each_voxel(const VoxelRange& range, const Emit& emit) {
  for (std::int32_t z = range.first.z; z <= range.last.z; ++z)
    for (std::int32_t y = range.first.y; y <= range.last.y; ++y)
      for (std::int32_t x = range.first.x; x <= range.last.x; ++x)
        emit(Vec3i{x, y, z});
}

// A connected primitive whose box meets just a line of voxels meets each of them.
inline bool is_line(const VoxelRange& range) {
  const int thick =
      (range.first.x != range.last.x) + (range.first.y != range.last.y) + (range.first.z != range.last.z);
  return thick <= 1;
}

// Calls emit(voxel) once for each voxel that the primitive is listed in.
template <class Emit>
void for_each_overlap(const Lattice& lattice, Overlap overlap, const Triangle<double>& triangle,
                      const Emit& emit) {
  const VoxelRange range = voxels_met(lattice, grown(bounds(triangle), lattice.margin));
  if (overlap == Overlap::box || is_line(range)) {
    for_each_voxel(range, emit);
    return;
  }
  const Vec3d size = voxel_size(lattice);
  const TriangleOverlap test(triangle, size * 0.5 + Vec3d{lattice.margin, lattice.margin, lattice.margin});
  // Columns along the axis the triangle faces hold few voxels of it each, however large it is.
  const int w = test.facing(), u = (w + 1) % 3, v = (w + 2) % 3;
  const auto center = [&](int axis, std::int32_t voxel) {
    return lattice.space.min[axis] + (voxel + 0.5) * size[axis];
  };
  for (std::int32_t j = range.first[v]; j <= range.last[v]; ++j) {
    for (std::int32_t i = range.first[u]; i <= range.last[u]; ++i) {
      Vec3d at{};
      at.set(u, center(u, i));
      at.set(v, center(v, j));
      double low, high;
      if (!test.column(at, low, high)) continue;
      const auto voxel_below = [&](double coordinate) {
        return (coordinate - lattice.space.min[w]) / size[w] - 0.5;
      };
      // The interval is of centres; a voxel more on both sides makes good its rounding, meets() decides.
      const double from = std::max(std::floor(voxel_below(low)), static_cast<double>(range.first[w]));
      const double to = std::min(std::ceil(voxel_below(high)), static_cast<double>(range.last[w]));
      for (std::int32_t k = static_cast<std::int32_t>(from); k <= to; ++k) {
        at.set(w, center(w, k));
        if (!test.meets(at)) continue;
        Vec3i voxel{};
        voxel.set(u, i);
        voxel.set(v, j);
        voxel.set(w, k);
        emit(voxel);
      }
    }
  }
}

// Spheres and cones.
template <class Primitive, class Emit>
void for_each_overlap(const Lattice& lattice, Overlap overlap, const Primitive& primitive, const Emit& emit) {
  const Boxd box = overlap == Overlap::box ? box_for_overlap(primitive) : bounds(primitive);
  const VoxelRange range = voxels_met(lattice, grown(box, lattice.margin));
  if (overlap == Overlap::box) {
    for_each_voxel(range, emit);
    return;
  }
  const Vec3d size = voxel_size(lattice);
  for_each_voxel(range, [&](const Vec3i& voxel) {
    const Vec3d low = lattice.space.min + cast<double>(voxel) * size;
    if (meets(primitive, Boxd{low, low + size}, lattice.margin)) emit(voxel);
  });
}

} // namespace masu
