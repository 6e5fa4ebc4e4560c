// The map of a cube of voxels that is divided into cells: see grid_view.h for its words.
#pragma once

#include "libgrid/partition.h"

#include <vector>

namespace masu {

// Appends the words that lead from the cube's voxels to their cells, and returns the word for the cube as a
// whole. The cube is 2^side_log2 voxels a side and begins at `first`, a multiple of its side. Cell i is
// leaves[i]; the leaves' boxes divide the cube. Places count from the beginning of `words`.
std::uint32_t append_nested_map(const std::vector<Leaf>& leaves, const Vec3i& first, std::int32_t side_log2,
                                std::vector<std::uint32_t>& words);

} // namespace masu
