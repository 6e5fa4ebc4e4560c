// The space and its division: where each voxel is, for the builder.
#pragma once

#include "libscene/geometry/box.h"

#include <algorithm>
#include <cmath>

namespace masu {

struct Lattice {
  Boxd space;
  Vec3i division;
  double margin; // how far beyond its surface a primitive is still listed
};

// Voxels from first to last, both included.
struct VoxelRange {
  Vec3i first, last;
};

MASU_HD inline Vec3d voxel_size(const Lattice& lattice) {
  const Vec3d extent = lattice.space.max - lattice.space.min;
  return {extent.x / lattice.division.x, extent.y / lattice.division.y, extent.z / lattice.division.z};
}

// The same space divided 2^bits times finer.
MASU_HD inline Lattice finer(const Lattice& lattice, std::int32_t bits) {
  const Vec3i& n = lattice.division;
  return {lattice.space, {n.x << bits, n.y << bits, n.z << bits}, lattice.margin};
}

MASU_HD inline std::uint64_t voxel_count(const Vec3i& division) {
  return static_cast<std::uint64_t>(division.x) * static_cast<std::uint64_t>(division.y) *
         static_cast<std::uint64_t>(division.z);
}

// The closed voxels, of size voxel_size(lattice), that the closed box meets; what lies outside the space goes
// to the outermost, NaN to the first.
MASU_HD inline VoxelRange voxels_met(const Lattice& lattice, const Vec3d& size, const Boxd& box) {
  VoxelRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    const double last = lattice.division[axis] - 1;
    const auto held = [last](double voxel) {
      return voxel > 0 ? static_cast<std::int32_t>(std::min(voxel, last)) : 0;
    };
    const double low = (box.min[axis] - lattice.space.min[axis]) / size[axis];
    const double high = (box.max[axis] - lattice.space.min[axis]) / size[axis];
    range.first.set(axis,
                    held(std::ceil(low) - 1)); // closed: a box that begins on a face meets both its voxels
    range.last.set(axis, held(std::floor(high)));
  }
  return range;
}
MASU_HD inline VoxelRange voxels_met(const Lattice& lattice, const Boxd& box) {
  return voxels_met(lattice, voxel_size(lattice), box);
}

} // namespace masu
