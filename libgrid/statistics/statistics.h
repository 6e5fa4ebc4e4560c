// What a grid holds, in numbers; and the occupancy of the 2012 thesis (docs/algorithm.md).
#pragma once

#include "libgrid/grid/division.h"
#include "libgrid/grid/grid.h"
#include "libgrid/grid/grid_layout.h"
#include "libscene/scene_view.h"

#include <span>
#include <vector>

namespace masu {

struct GridStatistics {
  std::uint64_t cells = 0, occupied_cells = 0; // a uniform grid's cells are its voxels
  std::uint64_t references = 0;
  // References of an occupied cell; all zero when none is occupied.
  double mean = 0, stddev = 0, median = 0;
  std::uint64_t p99 = 0, min = 0, max = 0;
  // Occupied cells by their number of references: histogram[n] of them list n.
  std::vector<std::uint64_t> histogram;
};

// Looks at all that the grid holds. `references` and `cells` as in grid.h.
GridStatistics grid_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references);
GridStatistics grid_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells);

// How many a list names; 0 for empty_list.
inline std::uint32_t references_of(const PrimitiveIndex* references, std::uint32_t list) {
  if (list == empty_list) return 0;
  std::uint32_t end = list;
  while ((references[end++] & last_bit) == 0) {
  }
  return end - list;
}

// How many of the layout's voxels hold a primitive.
template <class Stored>
std::uint64_t occupied_voxels(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap);

// The same for bounding boxes and voxels without their upper faces: what lies on a face is in the voxel above
// it alone. No grid is built so, since rays on such faces could miss; the thesis seems to have counted so.
template <class Stored>
std::uint64_t occupied_half_open(const SceneView<Stored>& scene, const GridLayout& layout);

} // namespace masu
