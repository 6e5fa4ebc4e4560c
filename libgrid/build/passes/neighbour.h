// What the expansion reads of a cell's neighbours.
#pragma once

#include "libgrid/build/passes/list.h"

namespace masu {

// The most neighbours a face looks at: one more of them would sooner or later be in the way.
inline constexpr std::int32_t max_neighbours = 32;

// Half a cache line.
struct alignas(32) Neighbour {
  std::uint32_t own[3];      // the voxels that lead to it
  std::uint32_t expanded[3]; // its box after the round before
  std::uint32_t signature;
  std::uint32_t list;
};
static_assert(sizeof(Neighbour) == 32);

MASU_HD inline Neighbour as_neighbour(const MergedCell& cell, const PrimitiveIndex* references) {
  return {{cell.x, cell.y, cell.z}, {cell.x, cell.y, cell.z}, signature_of(references, cell.list), cell.list};
}

MASU_HD inline void set_expanded(Neighbour& neighbour, const MergedCell& cell) {
  neighbour.expanded[0] = cell.x;
  neighbour.expanded[1] = cell.y;
  neighbour.expanded[2] = cell.z;
}

} // namespace masu
