// A grid as tracing sees it: where its arrays lie, on the host or on the device. Passed by value.
//
// The space is divided into division.x × division.y × division.z voxels. A voxel map says what each one
// holds. What it holds is a list: references[list] and those after it, in rising order of primitives, up to
// the one with last_bit.
//
// A uniform grid's voxel is a cell of its own. Its map has a 32-bit word per voxel, x fastest:
//
//   bit 31 set    occupied: the other bits are its list
//   0             empty
//
// Large maps have two levels: one word for each block of 2^block_log2 voxels per side (the last block of a
// row may reach beyond the space), its other bits the number of the block's own map, 8^block_log2 words
// further back, x fastest; an empty block has no map of its own. Small maps have block_log2 = 0: the blocks
// are the voxels.
//
// A merged grid's cell is a box of voxels; its map leads from a voxel to its cell in one to a few words. The
// top level has a word for each cube of 2^nested_log2 voxels per side:
//
//   bit 31 set    all of the cube is in one cell: the other bits are its number
//   bit 31 clear  divided: bits 0-1, 2-3 and 4-5 are the logarithms a, b and c of how often along x, y, z;
//                 from bit 6 on stands a quarter of the place of 2^(a+b+c) more such words, one for each of
//                 the boxes it is divided into, x fastest
//
// A cell's box may reach beyond the voxels that lead to it, over others that hold nothing or nothing else
// than it does: whoever enters it there may leave it through the box's far side.
#pragma once

#include "libgrid/bits.h"
#include "libscene/base/fetch.h"
#include "libscene/geometry/primitives.h"

namespace masu {

inline constexpr std::uint32_t occupied_bit = 0x80000000U;
inline constexpr std::uint32_t last_bit = 0x80000000U;
inline constexpr std::uint32_t empty_list = 0xffffffffU;

// Primitives, references, cells and words of the map are numbered with what bit 31 leaves.
inline constexpr std::uint64_t max_numbered = 0x7fffffff;

template <class Real>
struct GridView {
  const std::uint32_t* voxel_map;
  const PrimitiveIndex* references;
  Vec3<Real> min;        // the space's lower corner
  Vec3<Real> voxel_size; // never zero
  Vec3<Real> voxels_per_unit;
  Vec3i division;
  Vec3i blocks; // division in blocks, rounded up
  std::int32_t block_log2;
};

// Along each axis the first voxel of the box, and from bit 16 on the first beyond it.
struct alignas(16) MergedCell {
  std::uint32_t x, y, z;
  std::uint32_t list; // empty_list when empty
};
static_assert(sizeof(MergedCell) == 16);

// The ends of a cell's box along an axis.
MASU_HD inline std::int32_t first_of(std::uint32_t range) {
  return static_cast<std::int32_t>(range & 0xffff);
}
MASU_HD inline std::int32_t end_of(std::uint32_t range) {
  return static_cast<std::int32_t>(range >> 16);
}

template <class Real>
struct MergedGridView {
  const std::uint32_t* voxel_map;
  const MergedCell* cells;
  const PrimitiveIndex* references;
  Vec3<Real> min;
  Vec3<Real> voxel_size;
  Vec3<Real> voxels_per_unit;
  Vec3i division; // in the smallest voxels
  Vec3i top;      // the map's top level; top · 2^nested_log2 = division
  std::int32_t nested_log2;
};

MASU_HD inline std::uint64_t voxel_count(const Vec3i& division) {
  return static_cast<std::uint64_t>(division.x) * static_cast<std::uint32_t>(division.y) *
         static_cast<std::uint32_t>(division.z);
}

MASU_HD inline std::uint64_t linear_index(const Vec3i& at, const Vec3i& size) {
  return (static_cast<std::uint64_t>(at.z) * static_cast<std::uint32_t>(size.y) +
          static_cast<std::uint32_t>(at.y)) *
             static_cast<std::uint32_t>(size.x) +
         static_cast<std::uint32_t>(at.x);
}

// The index of a cube in what it's a part of, 2^side_log2 cubes per side; other bits don't matter.
MASU_HD inline std::uint32_t index_in_block(const Vec3i& cube, int side_log2) {
  const std::int32_t mask = (1 << side_log2) - 1;
  return static_cast<std::uint32_t>((((cube.z & mask) << side_log2 | (cube.y & mask)) << side_log2) |
                                    (cube.x & mask));
}

MASU_HD inline Vec3i shifted(const Vec3i& v, int bits) {
  return {v.x >> bits, v.y >> bits, v.z >> bits};
}

// What the map says of a voxel: the word, and the side of the block it speaks for (as a power of two).
struct MapEntry {
  std::uint32_t word;
  std::int32_t side_log2;
};

template <class Real>
MASU_HD inline MapEntry look_up(const GridView<Real>& grid, const Vec3i& voxel) {
  if (grid.block_log2 == 0) return {grid.voxel_map[linear_index(voxel, grid.division)], 0};
  const int b = grid.block_log2;
  const std::uint32_t block = grid.voxel_map[linear_index(shifted(voxel, b), grid.blocks)];
  if ((block & occupied_bit) == 0) return {block, b};
  const std::uint64_t map =
      voxel_count(grid.blocks) + (static_cast<std::uint64_t>(block & ~occupied_bit) << (3 * b));
  return {grid.voxel_map[map + index_in_block(voxel, b)], 0};
}

// How a word of a merged grid's map divides its box further.
struct MapDivision {
  std::uint32_t offset; // of the first word
  Vec3i log2;
};
inline constexpr std::uint32_t max_division_log2 = 3;
inline constexpr std::uint32_t offset_unit_log2 = 2;
inline constexpr std::uint64_t max_nested_words = std::uint64_t{1} << 27;

MASU_HD inline MapDivision map_division(std::uint32_t word) {
  return {word >> 6 << offset_unit_log2,
          {static_cast<std::int32_t>(word & 3), static_cast<std::int32_t>(word >> 2 & 3),
           static_cast<std::int32_t>(word >> 4 & 3)}};
}
MASU_HD inline std::uint32_t map_word(const MapDivision& division) {
  return division.offset >> offset_unit_log2 << 6 | static_cast<std::uint32_t>(division.log2.z) << 4 |
         static_cast<std::uint32_t>(division.log2.y) << 2 | static_cast<std::uint32_t>(division.log2.x);
}
// Which of the words is a box's, whose place along each axis are the lowest bits of `at`.
MASU_HD inline std::uint32_t index_in_division(const Vec3i& at, const Vec3i& log2) {
  const auto low = [](std::int32_t value, std::int32_t bits) {
    return static_cast<std::uint32_t>(value) & ((1U << bits) - 1);
  };
  return ((low(at.z, log2.z) << log2.y | low(at.y, log2.y)) << log2.x) | low(at.x, log2.x);
}

// On a voxel's way down a merged grid's map: the word it has come to, and along each axis the bits of its
// place in the cube that are still to be used, from the highest on.
struct MapPlace {
  std::uint32_t word, x, y, z;
};

template <class Real>
MASU_HD inline MapPlace top_place(const MergedGridView<Real>& grid, const Vec3i& voxel) {
  const Vec3i top = shifted(voxel, grid.nested_log2);
  return {grid.voxel_map[static_cast<std::uint32_t>((top.z * grid.top.y + top.y) * grid.top.x + top.x)],
          moved_to_top(voxel.x, grid.nested_log2), moved_to_top(voxel.y, grid.nested_log2),
          moved_to_top(voxel.z, grid.nested_log2)};
}

// To the next word, of a box that is divided.
MASU_HD inline void step_down(const std::uint32_t* voxel_map, MapPlace& place) {
  const MapDivision division = map_division(place.word);
  const Vec3i& log2 = division.log2; // index_in_division(), bit by bit
  const std::uint32_t index =
      appended(appended(appended(0, place.z, log2.z), place.y, log2.y), place.x, log2.x);
  place.x <<= log2.x;
  place.y <<= log2.y;
  place.z <<= log2.z;
  place.word = voxel_map[division.offset + index];
}

// The number of the cell that a voxel of a merged grid leads to.
template <class Real>
MASU_HD inline std::uint32_t cell_number(const MergedGridView<Real>& grid, const Vec3i& voxel) {
  MapPlace place = top_place(grid, voxel);
  while ((place.word & occupied_bit) == 0)
    step_down(grid.voxel_map, place);
  return place.word & ~occupied_bit;
}

// A cell as a walk through one of its voxels needs it.
struct CellView {
  std::uint32_t list;
  Vec3i far; // along each axis the plane that ends it, in the walk's direction
  bool one_voxel;
};

// `reversed` is -1 along an axis on which the walk goes down, else 0.
template <class Real>
MASU_HD inline CellView cell_at(const GridView<Real>& grid, const Vec3i& voxel, const Vec3i& reversed) {
  const MapEntry entry = look_up(grid, voxel);
  const int side = entry.side_log2;
  const auto far = [side](std::int32_t at, std::int32_t back, std::int32_t division) {
    const std::int32_t plane = ((at >> side) + 1 + back) << side;
    return plane < division ? plane : division;
  };
  return {(entry.word & occupied_bit) != 0 ? entry.word & ~occupied_bit : empty_list,
          {far(voxel.x, reversed.x, grid.division.x), far(voxel.y, reversed.y, grid.division.y),
           far(voxel.z, reversed.z, grid.division.z)},
          side == 0};
}

template <class Real>
MASU_HD inline CellView cell_at(const MergedGridView<Real>& grid, const Vec3i& voxel, const Vec3i& reversed) {
  const MergedCell cell = fetched(grid.cells + cell_number(grid, voxel));
  return {cell.list, {half(cell.x, reversed.x), half(cell.y, reversed.y), half(cell.z, reversed.z)}, false};
}

} // namespace masu
