// Expanding cells over their neighbours, after Pérard-Gayot, Kalojanov & Slusallek, "GPU Ray Tracing using
// Irregular Grids", CGF 36(2), 2017: a ray that leaves an expanded cell has passed neighbours that list
// nothing new to it.
//
// Each round expands cells over neighbours that are empty or list nothing but what the cell lists itself, by
// one layer along each direction; neighbours count as they are after the round before.
#pragma once

#include "libgrid/grid/grid.h"
#include "libscene/passes/executor.h"

#include <algorithm>

namespace masu {

// Whether all primitives of the list `part` are in the list `whole`.
MASU_HD inline bool lists_all(const PrimitiveIndex* references, std::uint32_t whole, std::uint32_t part) {
  if (part == empty_list) return true;
  if (whole == empty_list) return false;
  for (;;) {
    const PrimitiveIndex wanted = references[part], found = references[whole];
    if ((wanted & ~last_bit) == (found & ~last_bit)) {
      if ((wanted & last_bit) != 0) return true;
      ++part;
    } else if ((wanted & ~last_bit) < (found & ~last_bit)) {
      return false;
    }
    if ((found & last_bit) != 0) return false;
    ++whole;
  }
}

// A bit for each primitive of a list, several to a bit: 0 for an empty list alone, and a part's bits are
// among the whole's.
MASU_HD inline std::uint32_t signature_of(const PrimitiveIndex* references, std::uint32_t list) {
  if (list == empty_list) return 0;
  std::uint32_t signature = 0;
  for (bool last = false; !last; ++list) {
    last = (references[list] & last_bit) != 0;
    // Neighbours in space are often numbered in steps: the golden ratio spreads them over the bits.
    signature |= 1U << ((references[list] & ~last_bit) * 0x9e3779b1U >> 27);
  }
  return signature;
}

// The most neighbours a face looks at: one more of them would sooner or later be in the way.
inline constexpr std::int32_t max_neighbours = 32;

// What the expansion reads of a cell's neighbours: half a cache line.
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

// Where a cell's face can be moved to.
struct Reach {
  bool free;          // no neighbour is in the way
  std::int32_t plane; // where the face goes then
};

// Of the cell's face on one side along an axis, which isn't the space's. Row by row along u, then v, each
// neighbour is found through the map; the next row begins where the first of this row's neighbours ends.
template <int axis>
MASU_HD Reach reach_of(const MergedGridView<double>& grid, const Neighbour* neighbours,
                       const MergedCell& cell, std::uint32_t signature, bool upwards) {
  constexpr int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::uint32_t ranges[3] = {cell.x, cell.y, cell.z};
  Vec3i voxel{};
  voxel.set(axis, upwards ? end_of(ranges[axis]) : first_of(ranges[axis]) - 1);
  Reach reach{true, upwards ? 0xffff : 0};
  std::int32_t seen = 0, next_j = 0;
  for (std::int32_t j = first_of(ranges[v]); j < end_of(ranges[v]); j = next_j) {
    next_j = end_of(ranges[v]);
    for (std::int32_t i = first_of(ranges[u]); i < end_of(ranges[u]);) {
      voxel.set(u, i);
      voxel.set(v, j);
      const Neighbour neighbour = fetched(neighbours + cell_number(grid, voxel));
      if ((neighbour.signature & ~signature) != 0 || seen == max_neighbours ||
          !lists_all(grid.references, cell.list, neighbour.list))
        return {false, 0};
      ++seen;
      const std::uint32_t along = neighbour.expanded[axis];
      reach.plane = upwards ? std::min(reach.plane, end_of(along)) : std::max(reach.plane, first_of(along));
      i = end_of(neighbour.own[u]);
      next_j = std::min(next_j, end_of(neighbour.own[v]));
    }
  }
  return reach;
}

// Both of each cell's faces along an axis. What is in the way stays in the way, since faces only grow: a bit
// of `blocked` for each of a cell's six.
template <int axis, class Executor>
void expand_along(Executor& executor, const MergedGridView<double>& grid, const Neighbour* neighbours,
                  std::uint64_t count, MergedCell* cells, std::uint8_t* blocked) {
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    constexpr unsigned both = 3U << (2 * axis);
    unsigned bits = blocked[i];
    if ((bits & both) == both) return;
    MergedCell cell = cells[i];
    std::uint32_t& range = axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
    std::uint32_t expanded = range;
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned bit = 1U << (2 * axis + static_cast<int>(side));
      if ((bits & bit) != 0) continue;
      const bool upwards = side == 1;
      const bool at_end = upwards ? end_of(range) == grid.division[axis] : first_of(range) == 0;
      Reach reach{false, 0};
      if (!at_end) reach = reach_of<axis>(grid, neighbours, cell, neighbours[i].signature, upwards);
      if (!reach.free) {
        bits |= bit;
        continue;
      }
      const auto at = static_cast<std::uint32_t>(reach.plane);
      expanded = upwards ? (expanded & 0xffffU) | at << 16 : (expanded & 0xffff0000U) | at;
    }
    (axis == 0 ? cells[i].x : axis == 1 ? cells[i].y : cells[i].z) = expanded;
    blocked[i] = static_cast<std::uint8_t>(bits);
  });
}

// `grid` is a view of what `cells` are the cells of, in the executor's memory.
template <class Executor>
void expand_cells(Executor& executor, const MergedGridView<double>& grid, std::uint64_t count,
                  MergedCell* cells, int rounds) {
  if (rounds == 0) return;
  auto neighbours = executor.template array<Neighbour>(count);
  auto blocked = executor.template zeros<std::uint8_t>(count);
  Neighbour* const neighbour = neighbours.data();
  executor.for_each(
      count, [=] MASU_PASS(std::uint64_t i) { neighbour[i] = as_neighbour(cells[i], grid.references); });
  for (int pass = 0; pass < rounds; ++pass) {
    expand_along<0>(executor, grid, neighbour, count, cells, blocked.data());
    expand_along<1>(executor, grid, neighbour, count, cells, blocked.data());
    expand_along<2>(executor, grid, neighbour, count, cells, blocked.data());
    if (pass + 1 == rounds) break;
    executor.for_each(count, [=] MASU_PASS(std::uint64_t i) { set_expanded(neighbour[i], cells[i]); });
  }
}

// The same cells on the host's cores, many faces side by side (expand.cpp): two fifths of the passes' time.
template <bool parallel>
class HostExecutor;
using TbbExecutor = HostExecutor<true>;
void expand_cells(TbbExecutor& executor, const MergedGridView<double>& grid, std::uint64_t count,
                  MergedCell* cells, int rounds);

} // namespace masu
