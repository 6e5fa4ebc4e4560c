// Building a uniform grid; and what a built grid is.
//
// Executor, in their order:
//   1. emit   primitives, in pieces of fixed size, list (voxel, primitive) pairs, sorted by bucket: a bucket
//             is a run of voxels in the order the map stores them
//   2. sort   each bucket gathers its pairs from all pieces and sorts them by voxel: references
//   3. map    each bucket writes its part of the voxel map
// Pieces and buckets don't depend on the number of threads, so neither does any byte of the result. No array
// has a place for each voxel but the map itself, and large maps have none for the empty blocks.
#pragma once

#include "libgrid/build/overlap.h"
#include "libgrid/build/storage_order.h"
#include "libgrid/grid_layout.h"
#include "libgrid/trace/grid_view.h"
#include "libscene/scene_view.h"

#include <vector>

namespace masu {

// none: each voxel is a cell. The others join voxels; see merge.h.
enum class Merge { none, x, balance, irregular };

// In host memory; see grid_view.h for what the arrays hold.
struct Grid {
  GridLayout layout{}; // a merged grid's smallest voxels are 2^nested_log2 times smaller
  Merge merge = Merge::none;
  std::int32_t block_log2 = 0;  // of uniform grids
  std::int32_t nested_log2 = 0; // of merged ones
  std::vector<std::uint32_t> voxel_map;
  std::vector<MergedCell> cells; // of merged ones
  std::vector<PrimitiveIndex> references;
};

// About how many bytes building takes at its peak, for so many references.
double expected_build_bytes(const GridLayout& layout, double references);

// Throws Error(usage, "--division", "makes …").
[[noreturn]] void too_fine(const char* makes);

// Throws Error(input) for more primitives than grids can number.
void check_primitives(std::uint64_t count);

// Throws Error(usage, "--division", …) past most_numbered references, Error(input) past as many primitives.
template <class Stored>
Grid build_uniform(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap);

} // namespace masu
