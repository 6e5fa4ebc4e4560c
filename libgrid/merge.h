// Building grids whose cells are boxes of several voxels.
//
//   x          the empty voxels of a run along x are joined: it costs a ray along it one step
//   balance    boxes of voxels that list no more than `target` primitives are one cell
//   irregular  each voxel of a coarse division is divided further, as deep as its primitives ask for, by
//              expected cost; cells are then stretched over neighbours (stretch.h)
#pragma once

#include "libgrid/build.h"
#include "libgrid/partition.h"

namespace masu {

struct MergeRule {
  Merge merge = Merge::none;
  std::uint32_t target = 8;     // balance: the most references of a cell, where voxels allow it
  double alpha = 1;             // irregular: how much a division must save to be made; see partition.h
  double step_over_test = 5;    // irregular: what a step costs, in tests
  double detail = 3;            // irregular: how much finer than its primitives a place is divided
  std::int32_t nested_log2 = 8; // irregular: a voxel is divided into at most 2^nested_log2 an axis
  int stretches = 4;            // irregular: passes of stretching; 0 for none
};

// The most voxels of a division whose grid is to be merged: its map has a word for each.
inline constexpr std::uint64_t most_merged_voxels = std::uint64_t{1} << 28;

// Doesn't depend on the number of threads. Throws Error(usage, "--division", …) for divisions that are too
// fine.
template <class Stored>
Grid build_merged(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap,
                  const MergeRule& rule);

} // namespace masu
