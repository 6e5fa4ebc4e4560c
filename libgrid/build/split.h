// Splitting a box of voxels into cells, top down: a kd-tree whose planes are those between the voxels, and of
// which only the leaves are kept.
#pragma once

#include "libgrid/build/build_options.h"
#include "libgrid/grid_layout.h"
#include "libscene/scene_view.h"

#include <span>
#include <vector>

namespace masu {

// The voxels from `first` to before `end` along each axis.
struct VoxelBox {
  Vec3i first, end;
};

// Kind irregular: a box is divided where the expected cost of a ray that meets it becomes least (the surface
//   area heuristic: Goldsmith & Salmon, IEEE CG&A 7(5), 1987; MacDonald & Booth, The Visual Computer 6(3),
//   1990), until no division makes it less than `alpha` times what it is. A test costs 1, the step to a cell
//   step_cost, that to an empty one half of it, since empty cells are joined further (expand_passes.h).
// Kind balance: until no cell lists more than `target` primitives, so that both halves list about as many.

// A cell and its list: references[begin] … references[begin + count - 1], in rising order.
struct Leaf {
  VoxelBox box;
  std::uint32_t begin, count;
};
struct Partition {
  std::vector<Leaf> leaves;
  std::vector<PrimitiveIndex> references;
};

// Of the box `root` of the layout's voxels, with all of `primitives` (in rising order) that the overlap test
// finds in it. Doesn't depend on the number of threads. No axis of the layout has more than 65535 voxels.
template <class Stored>
Partition partition(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                    const GridOptions& options, const VoxelBox& root,
                    std::span<const PrimitiveIndex> primitives);

} // namespace masu
