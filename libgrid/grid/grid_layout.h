// The space and its division: where each voxel is, for the builder.
#pragma once

#include "libgrid/grid/grid.h"
#include "libscene/geometry/box.h"

#include <algorithm>
#include <cmath>

namespace masu {

struct GridLayout {
  Boxd space;
  Vec3i division;
  double margin; // how far beyond its surface a primitive is still listed
};

// Voxels from first to last, both included.
struct VoxelRange {
  Vec3i first, last;
};

// The voxels from `first` to before `end` along each axis.
struct VoxelBox {
  Vec3i first, end;
};

// Those of a merged grid's cell.
MASU_HD inline VoxelBox box_of(const MergedCell& cell) {
  return {{first_of(cell.x), first_of(cell.y), first_of(cell.z)},
          {end_of(cell.x), end_of(cell.y), end_of(cell.z)}};
}

MASU_HD inline Vec3d voxel_size(const GridLayout& layout) {
  const Vec3d extent = layout.space.max - layout.space.min;
  return {extent.x / layout.division.x, extent.y / layout.division.y, extent.z / layout.division.z};
}

// The same space divided 2^bits times finer.
MASU_HD inline GridLayout finer(const GridLayout& layout, std::int32_t bits) {
  const Vec3i& n = layout.division;
  return {layout.space, {n.x << bits, n.y << bits, n.z << bits}, layout.margin};
}

// A division in blocks of 2^block_log2 voxels per side, rounded up.
inline Vec3i blocks_of(const Vec3i& division, std::int32_t block_log2) {
  const std::int32_t round = (1 << block_log2) - 1;
  return {(division.x + round) >> block_log2, (division.y + round) >> block_log2,
          (division.z + round) >> block_log2};
}

// The closed voxels, of size voxel_size(layout), that the closed box meets; what lies outside the space goes
// to the outermost, NaN to the first.
MASU_HD inline VoxelRange voxels_met(const GridLayout& layout, const Vec3d& size, const Boxd& box) {
  VoxelRange range{};
  for (int axis = 0; axis < 3; ++axis) {
    const double last = layout.division[axis] - 1;
    const auto clamp = [last](double voxel) {
      return voxel > 0 ? static_cast<std::int32_t>(std::min(voxel, last)) : 0;
    };
    const double low = (box.min[axis] - layout.space.min[axis]) / size[axis];
    const double high = (box.max[axis] - layout.space.min[axis]) / size[axis];
    range.first.set(axis,
                    clamp(std::ceil(low) - 1)); // closed: a box that begins on a face meets both its voxels
    range.last.set(axis, clamp(std::floor(high)));
  }
  return range;
}

// How large the blocks of a uniform grid's map are: single voxels while a word each costs little (32 MiB).
inline std::int32_t block_log2_for(const Vec3i& division) {
  constexpr std::uint64_t dense_voxels = std::uint64_t{1} << 23;
  constexpr std::int32_t sparse_block_log2 = 3;
  return voxel_count(division) <= dense_voxels ? 0 : sparse_block_log2;
}

// The order in which a uniform grid's map stores its voxels: block by block, x fastest, and so within each
// block.
struct StorageOrder {
  Vec3i division, blocks;
  std::int32_t block_log2;

  StorageOrder(const Vec3i& voxels, std::int32_t side_log2)
      : division(voxels), blocks(blocks_of(voxels, side_log2)), block_log2(side_log2) {}

  std::uint64_t size() const { return voxel_count(blocks) << (3 * block_log2); }
  MASU_HD std::uint64_t index(const Vec3i& voxel) const {
    if (block_log2 == 0) return linear_index(voxel, division);
    return (linear_index(shifted(voxel, block_log2), blocks) << (3 * block_log2)) +
           index_in_block(voxel, block_log2);
  }
};

} // namespace masu
