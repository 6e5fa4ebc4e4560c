// Building grids whose cells are boxes of several voxels.
//
//   x          the empty voxels of a run along x are joined: it costs a ray along it one step
//   balance    boxes of voxels that list no more than `target` primitives are one cell
//   irregular  each voxel of a coarse division is divided further, as deep as its primitives ask for, by
//              expected cost; cells are then expanded over neighbours (stretch.h)
#pragma once

#include "libgrid/build/build.h"
#include "libgrid/build/split.h"

namespace masu {

struct MergeRule {
  Merge merge = Merge::none;
  std::uint32_t target = 8;     // balance: the most references of a cell, where voxels allow it
  double alpha = 0.95;          // irregular: how much a division must save to be made; see partition.h
  double step_over_test = 5;    // irregular: what a step costs, in tests
  double detail = 3;            // irregular: how much finer than its primitives a place is divided
  std::int32_t nested_log2 = 8; // irregular: a voxel is divided into at most 2^nested_log2 an axis
  int expansions = 4;           // irregular: passes of stretching; 0 for none
};

// The most voxels of a division whose grid is to be merged: its map has a word for each.
inline constexpr std::uint64_t most_merged_voxels = std::uint64_t{1} << 28;

inline constexpr std::int32_t largest_plane = 65535; // a cell's box has 16 bits for it

MASU_HD inline MergedCell packed(const VoxelBox& box, std::uint32_t list) {
  const auto range = [&](int axis) {
    return static_cast<std::uint32_t>(box.first[axis]) | static_cast<std::uint32_t>(box.end[axis]) << 16;
  };
  return {range(0), range(1), range(2), list};
}

// The voxels of a merged grid's cell.
MASU_HD inline VoxelBox box_of(const MergedCell& cell) {
  return {{first_of(cell.x), first_of(cell.y), first_of(cell.z)},
          {end_of(cell.x), end_of(cell.y), end_of(cell.z)}};
}

// How an irregular grid's voxels are divided further: as often as planes can be numbered.
std::int32_t nested_log2_for(const Vec3i& division, const MergeRule& rule);
inline PartitionRule partition_rule(const MergeRule& rule) {
  return {true, rule.step_over_test, rule.alpha, rule.detail, 0};
}

// Throw Error(usage, "--division", …): before building, for too many voxels; and for what has become too
// large, the map being of `words` words, the first top_words of them its top level.
void check_mergeable(const Vec3i& division);
void check_merged_sizes(std::uint64_t cells, std::uint64_t references, std::uint64_t top_words,
                        std::uint64_t words);

// Doesn't depend on the number of threads. Throws Error(usage, "--division", …) for divisions that are too
// fine.
template <class Stored>
Grid build_merged(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                  const MergeRule& rule);

} // namespace masu
