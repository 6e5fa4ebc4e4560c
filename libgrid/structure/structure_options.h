// What kind of grid is built, and how.
#pragma once

#include "libgrid/grid/division.h"
#include "libgrid/grid/grid.h"
#include "libgrid/grid/overlap/overlap.h"

namespace masu {

//   uniform    each voxel is a cell
//   x          the empty voxels of a run along x are joined: it costs a ray along it one step
//   balance    boxes of voxels that list no more than `target` primitives are one cell
//   irregular  each voxel of a coarse division is divided further, as deep as its primitives demand, by
//              expected cost (splitter.h); cells are then expanded over neighbours (expand_passes.h)
//   hierarchy  no voxels: a bounding volume hierarchy (hierarchy_builder.h)
//   automatic  uniform or irregular, by tracing some rays through both (chosen_structure.h)
//   fastest    uniform, irregular or hierarchy, likewise
// What is built is of none of the last two. Merges are numbered as schemas/structure.fbs numbers them.
enum class StructureKind { uniform, x, balance, irregular, hierarchy, automatic, fastest };

// How a hierarchy is split: primitives, too, where boxes would overlap (high, fragment_split.h), or none of
// them (fast, leaf_split.h), in a third of the time. Numbered as in schemas/structure.fbs.
enum class HierarchyQuality { high, fast };

// A kind and its options; those of other kinds don't matter.
struct StructureOptions {
  StructureKind kind = StructureKind::uniform;
  std::uint32_t target = 8; // balance: the most references of a cell, where voxels allow it
  double alpha = 0.95;      // irregular: divide while that makes the cost less than alpha times what it is
  double step_cost = 5;     // irregular: of the step to a cell, in intersection tests (unit_costs.h)
  double detail = 3;        // irregular: planes no closer than a primitive's typical extent over this
  std::int32_t nested_log2 = 8; // irregular: a voxel is divided into at most 2^nested_log2 an axis
  int expand = 4;               // irregular: rounds of expansion; 0 for none
  // irregular: where one of the limits below is exceeded, half of the detail is tried, as long as that is no
  // less than this. It takes a third of the words, and hardly adds references.
  double least_detail = 0.1;
  std::uint64_t max_map_words = max_nested_words;  // uniform, irregular: of its map
  std::uint64_t max_references = max_numbered;     // of voxels, before they are joined or divided further
  std::uint64_t max_fragments = ~std::uint64_t{0}; // irregular, balance: of all levels (split_passes.h)
  HierarchyQuality quality = HierarchyQuality::high;
};

// What an automatic choice is made for.
enum class Processor { gpu, cpu };

struct BuildOptions {
  StructureOptions structure{StructureKind::automatic};
  DivisionRule division;
  Processor processor = Processor::gpu;
  SpaceRule space = SpaceRule::tight;
  Overlap overlap = Overlap::exact;
};

} // namespace masu
