// Building a uniform grid; and what a built grid is.
//
// Passes, in their order:
//   1. emit   primitives, in pieces of fixed size, list (voxel, primitive) pairs, sorted by bucket: a bucket
//             is a run of voxels in the order the map stores them
//   2. sort   each bucket gathers its pairs from all pieces and sorts them by voxel: references
//   3. map    each bucket writes its part of the voxel map
// Pieces and buckets don't depend on the number of threads, so neither does any byte of the result. No array
// has a place for each voxel but the map itself, and large maps have none for the empty blocks.
#pragma once

#include "libgrid/grid_view.h"
#include "libgrid/lattice.h"
#include "libgrid/overlap.h"
#include "libscene/scene_view.h"

#include <vector>

namespace masu {

// none: each voxel is a cell. The others join voxels; see merge.h.
enum class Merge { none, x, balance, irregular };

// In host memory; see grid_view.h for what the arrays hold.
struct Grid {
  Lattice lattice{}; // a merged grid's smallest voxels are 2^nested_log2 times smaller
  Merge merge = Merge::none;
  std::int32_t block_log2 = 0;  // of uniform grids
  std::int32_t nested_log2 = 0; // of merged ones
  std::vector<std::uint32_t> voxel_map;
  std::vector<MergedCell> cells; // of merged ones
  std::vector<PrimitiveIndex> references;
};

// How large the map's blocks are: single voxels while a word each costs little.
std::int32_t block_log2_for(const Vec3i& division);

inline Vec3i blocks_of(const Vec3i& division, std::int32_t block_log2) {
  const std::int32_t round = (1 << block_log2) - 1;
  return {(division.x + round) >> block_log2, (division.y + round) >> block_log2,
          (division.z + round) >> block_log2};
}

// About how many bytes building takes at its peak, for so many references.
double expected_build_bytes(const Lattice& lattice, double references);

// Throws Error(usage, "--division", …) past most_numbered references or primitives.
template <class Stored>
Grid build_uniform(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap);

} // namespace masu
