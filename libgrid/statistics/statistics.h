// What a grid holds, in numbers: its cells' lists; how large cells are, how the map leads to them, and how
// many of them a ray is expected to meet; the occupancy of the 2012 thesis (docs/algorithm.md). And what a
// bounding volume hierarchy holds.
#pragma once

#include "libgrid/grid/division.h"
#include "libgrid/hierarchy/hierarchy.h"

#include <functional>
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
  std::vector<std::uint64_t> histogram{};
};

// How many a list names; 0 for empty_list.
inline std::uint32_t references_of(const PrimitiveIndex* references, std::uint32_t list) {
  if (list == empty_list) return 0;
  std::uint32_t end = list;
  while ((references[end++] & last_bit) == 0) {
  }
  return end - list;
}

// What a random line through the space meets. It meets a box within the space with the probability of the
// box's surface area over the space's (Crofton), so cells and tests are sums over the cells' own boxes.
// Assumed: nothing stops the ray, all such lines are equally likely, and a primitive that several cells list
// is tested in each. Rays that begin or end within the scene meet less; a walk leaves expanded cells through
// the box they were expanded to, and so enters fewer cells than these.
struct ExpectedRay {
  double cells = 0; // an empty block of a uniform grid's map is one
  double tests = 0;
  double voxels_skipped = 0; // steps saved beside a walk through every smallest voxel
};

struct MapStatistics {
  std::uint64_t voxels = 0, occupied_voxels = 0; // the smallest
  std::vector<std::uint64_t> words;              // of the map by level, the top one's first
  double loads = 0;                              // of words of the map, for a random point
  ExpectedRay ray;
  // Of merged grids: cells by size, cells_by_size[n] of 2^n to 2^(n+1) - 1 voxels of their own; and how many
  // times larger expansion made their boxes, in the geometric mean over all cells, since a few cells' grow
  // beyond all others.
  std::vector<std::uint64_t> cells_by_size;
  std::uint64_t expanded_cells = 0;
  double mean_expansion = 1;
};

// Look at all that the grid or its map holds. `references` and `cells` as in grid.h: each list is one cell's.
GridStatistics grid_statistics(std::uint64_t cells, std::span<const PrimitiveIndex> references);
MapStatistics map_statistics(const GridView<double>& grid, std::span<const PrimitiveIndex> references);
MapStatistics map_statistics(const MergedGridView<double>& grid, std::span<const MergedCell> cells);

// The voxels that lead to a cell: how many, and the box around them, which they fill in grids that gridbuild
// makes. A cell to which none leads has voxels = 0 and an unspecified box.
struct OwnVoxels {
  VoxelBox box{{0xffff, 0xffff, 0xffff}, {0, 0, 0}};
  std::uint64_t voxels = 0;
};

// One for each cell.
std::vector<OwnVoxels> own_voxels(const MergedGridView<double>& grid, std::span<const MergedCell> cells);

// How many of the layout's voxels hold a primitive.
template <class Stored>
std::uint64_t occupied_voxels(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap);

// The same for bounding boxes and voxels without their upper faces: what lies on a face is in the voxel above
// it alone. No grid is built so, since rays on such faces could miss; the thesis seems to have counted so.
template <class Stored>
std::uint64_t occupied_half_open(const SceneView<Stored>& scene, const GridLayout& layout);

struct HierarchyStatistics {
  std::uint64_t nodes = 0;
  std::uint64_t node_boxes = 0, reference_boxes = 0; // boxes of nodes, and of references
  std::uint64_t references = 0;
  int depth = 0;             // nodes from the root to the deepest, both counted
  double boxes_per_node = 0; // of 8, mean
  // Of a random ray that meets the root's box: nodes visited, and references tested, if nothing stopped it
  // (the surface area heuristic's expectation: Goldsmith & Salmon, "Automatic Creation of Object Hierarchies
  // for Ray Tracing", IEEE CG&A 7(5), 1987).
  double nodes_per_ray = 0, tests_per_ray = 0;
  std::vector<std::uint64_t> boxes_by_references{}, boxes_by_depth{}; // boxes of references
};

// A box of a node: around another node, or around references.
struct HierarchyBox {
  std::uint32_t node;
  int slot, depth;          // of the node; the root's is 0
  std::uint32_t references; // 0 for a box around a node
  std::uint32_t inner;      // that node; 0, the root, for a box of references
};
// In the order of the nodes, and in a node of the slots. Of checked nodes.
void for_each_box(std::span<const HierarchyNode> nodes, const std::function<void(const HierarchyBox&)>& act);

// Of checked nodes.
HierarchyStatistics hierarchy_statistics(std::span<const HierarchyNode> nodes);

} // namespace masu
