// The order in which a uniform grid's map stores its voxels.
#pragma once

#include "libgrid/grid/grid.h"
#include "libgrid/grid/grid_layout.h"

namespace masu {

// How large the map's blocks are: single voxels while a word each costs little (32 MiB).
inline std::int32_t block_log2_for(const Vec3i& division) {
  constexpr std::uint64_t dense_voxels = std::uint64_t{1} << 23;
  constexpr std::int32_t sparse_block_log2 = 3;
  return voxel_count(division) <= dense_voxels ? 0 : sparse_block_log2;
}

// Block by block, x fastest, and so within each block.
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
