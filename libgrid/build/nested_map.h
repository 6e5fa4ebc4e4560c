// The map of a cube of voxels that is divided into cells: see grid_view.h for its words.
#pragma once

#include "libgrid/build/split.h"
#include "libgrid/trace/grid_view.h"

#include <algorithm>
#include <vector>

namespace masu {

// No more words than this for each cell that they lead to, unless one step down needs them: what is left of
// the depth takes another step.
inline constexpr std::uint32_t words_a_cell = 4;

inline constexpr std::uint32_t most_parts = 1U << (3 * most_division_log2);

// 2^log2 voxels along each axis.
struct MapPlace {
  Vec3i first, log2;
};

MASU_HD inline std::uint32_t parts_of(const Vec3i& division) {
  return 1U << (division.x + division.y + division.z);
}

// Words begin at multiples of the unit.
MASU_HD inline std::uint64_t rounded_to_unit(std::uint64_t words) {
  constexpr std::uint64_t rest = (std::uint64_t{1} << place_unit_log2) - 1;
  return (words + rest) & ~rest;
}

// The bits of where a cell's planes are within the place along an axis, counted from its beginning.
MASU_HD inline std::uint32_t plane_bits(const MapPlace& place, const VoxelBox& cell, int axis) {
  const auto bits_of_plane = [&](std::int32_t plane) {
    const std::int32_t at = plane - place.first[axis];
    return at > 0 && at < (1 << place.log2[axis]) ? static_cast<std::uint32_t>(at) : 0U;
  };
  return bits_of_plane(cell.first[axis]) | bits_of_plane(cell.end[axis]);
}

// How often a place that so many cells divide between them is divided along each axis: so often that every
// part is in one cell, if that doesn't take too many words. `planes`: all their bits.
MASU_HD inline Vec3i map_division_for(const MapPlace& place, const std::uint32_t (&planes)[3],
                                      std::uint32_t cells) {
  Vec3i division{};
  for (int axis = 0; axis < 3; ++axis) {
    std::int32_t finest = 0;
    while (finest < place.log2[axis] && (planes[axis] >> finest & 1) == 0)
      ++finest;
    division.set(axis, std::min(place.log2[axis] - finest, static_cast<std::int32_t>(most_division_log2)));
  }
  while (parts_of(division) > 2 && parts_of(division) > std::uint64_t{words_a_cell} * cells) {
    const int most = division.x >= division.y && division.x >= division.z ? 0
                     : division.y >= division.z                           ? 1
                                                                          : 2;
    division.set(most, division[most] - 1);
  }
  return division;
}

// The parts of the divided place that a cell has some of, and a part's own place.
MASU_HD inline VoxelRange map_parts(const MapPlace& place, const Vec3i& division, const VoxelBox& cell) {
  VoxelRange parts{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t rest = place.log2[axis] - division[axis], from = place.first[axis];
    parts.first.set(axis, std::max(cell.first[axis] - from, 0) >> rest);
    parts.last.set(axis, std::min((cell.end[axis] - 1 - from) >> rest, (1 << division[axis]) - 1));
  }
  return parts;
}
MASU_HD inline MapPlace map_part(const MapPlace& place, const Vec3i& division, std::uint32_t part) {
  MapPlace own{place.first, place.log2 - division};
  std::uint32_t rest = part;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t at = rest & ((1U << division[axis]) - 1);
    own.first.set(axis, place.first[axis] + static_cast<std::int32_t>(at << own.log2[axis]));
    rest >>= division[axis];
  }
  return own;
}

// Appends the words that lead from the cube's voxels to their cells, and returns the word for the cube as a
// whole. The cube is 2^side_log2 voxels a side and begins at `first`, a multiple of its side. Cell i is
// leaves[i]; the leaves' boxes divide the cube. Places count from the beginning of `words`.
std::uint32_t append_nested_map(const std::vector<Leaf>& leaves, const Vec3i& first, std::int32_t side_log2,
                                std::vector<std::uint32_t>& words);

} // namespace masu
