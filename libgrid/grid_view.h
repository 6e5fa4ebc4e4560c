// A grid as tracing sees it: where its arrays lie, on the host or on the device. Passed by value.
//
// The space is divided into division.x × division.y × division.z voxels. Each voxel is in one cell, or empty.
// The voxel map says which, a 32-bit word a voxel:
//
//   bit 31 set    occupied: the other bits are the cell's number
//   bit 31 clear  empty
//
// Large maps have two levels: one word for each block of 2^block_log2 voxels a side (the last block of a row
// may reach beyond the space), its other bits the number of the block's own map, 8^block_log2 words further
// back, x fastest; an empty block has no map of its own. Small maps have block_log2 = 0: the blocks are the
// voxels.
//
// Cell c lists references[cells[c]] … references[cells[c + 1] - 1], in rising order.
#pragma once

#include "libscene/primitives.h"

namespace masu {

inline constexpr std::uint32_t occupied_bit = 0x80000000U;

template <class Real>
struct GridView {
  const std::uint32_t* voxel_map;
  const std::uint32_t* cells;
  const PrimitiveIndex* references;
  Vec3<Real> min;        // the space's lower corner
  Vec3<Real> voxel_size; // never zero
  Vec3<Real> voxels_per_unit;
  Vec3i division;
  Vec3i blocks; // division in blocks, rounded up
  std::int32_t block_log2;
};

MASU_HD inline std::uint64_t linear_index(const Vec3i& at, const Vec3i& size) {
  return (static_cast<std::uint64_t>(at.z) * static_cast<std::uint32_t>(size.y) +
          static_cast<std::uint32_t>(at.y)) *
             static_cast<std::uint32_t>(size.x) +
         static_cast<std::uint32_t>(at.x);
}

// A voxel's place in its block's own map.
MASU_HD inline std::uint32_t index_in_block(const Vec3i& voxel, int block_log2) {
  const std::int32_t mask = (1 << block_log2) - 1;
  return static_cast<std::uint32_t>((((voxel.z & mask) << block_log2 | (voxel.y & mask)) << block_log2) |
                                    (voxel.x & mask));
}

// Which cell a voxel belongs to: the map's word, and the side of the block it speaks for (as a power of two).
struct MapEntry {
  std::uint32_t word;
  std::int32_t side_log2;
};

template <class Real>
MASU_HD inline MapEntry look_up(const GridView<Real>& grid, const Vec3i& voxel) {
  if (grid.block_log2 == 0) return {grid.voxel_map[linear_index(voxel, grid.division)], 0};
  const int b = grid.block_log2;
  const std::uint32_t block =
      grid.voxel_map[linear_index({voxel.x >> b, voxel.y >> b, voxel.z >> b}, grid.blocks)];
  if ((block & occupied_bit) == 0) return {block, b};
  const std::uint64_t block_words = static_cast<std::uint64_t>(grid.blocks.x) *
                                    static_cast<std::uint32_t>(grid.blocks.y) *
                                    static_cast<std::uint32_t>(grid.blocks.z);
  const std::uint64_t map = block_words + (static_cast<std::uint64_t>(block & ~occupied_bit) << (3 * b));
  return {grid.voxel_map[map + index_in_block(voxel, b)], 0};
}

} // namespace masu
