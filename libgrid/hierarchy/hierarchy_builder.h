// Builds a bounding volume hierarchy (libgrid/hierarchy/hierarchy.h) on the host.
#pragma once

#include "libgrid/structure/structure.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/mesh/stored_triangles.h"

namespace masu {

// The most primitives of a hierarchy, 421,075,224: with what is divided, fragments and nodes can still be
// numbered.
inline constexpr double spare_leaves = 0.7;  // a primitive, for the parts of those that are divided before
inline constexpr double spare_fragments = 2; // a leaf, for what is divided later
inline constexpr auto max_hierarchy_primitives =
    static_cast<std::uint64_t>(static_cast<double>(0x7fffffff) / (1 + spare_leaves) / (1 + spare_fragments));

// Enough bytes per primitive for the binary hierarchy and what it is made into.
inline constexpr double hierarchy_bytes_per_primitive = 300;

// Throws Error(usage, "structure", …) for more, and where so many take more than `available` bytes of memory.
void check_hierarchy(std::uint64_t primitives, double available);

// Whether a hierarchy's float32 boxes, and sums of their areas, hold what is in this space.
inline constexpr double max_hierarchy_reach = 1e15;
inline bool fits_hierarchy(const Boxd& space) {
  return largest_magnitude(space) <= max_hierarchy_reach;
}

// Throws likewise where it doesn't.
void check_hierarchy(const Boxd& space);
// For both, with the memory that is free.
void check_hierarchy(std::uint64_t primitives, const Boxd& space);

// First leaves, of primitives and parts of them (leaf_passes.h); then a binary hierarchy of these, from the
// top down (binary_hierarchy.h); then the cheapest nodes of eight boxes that it can be collapsed to
// (collapse_passes.h). The same for any number of threads. As a grid it is of the layout's space, in one
// voxel; boxes contain the layout's margin around each primitive. The root comes first, then depth first, a
// node's nodes side by side. Scene: SceneView or MeshesView. `progress` gets shares of the work of high
// quality. Throws as check_hierarchy() does.
template <class Scene>
Structure build_hierarchy(const Scene& scene, const GridLayout& layout, HierarchyQuality quality = {},
                          ProgressMonitor* progress = nullptr);

// Fits a hierarchy to the scene's primitives where they have moved: the same nodes and references, with boxes
// of the layout's margin around what they hold. What was divided is held whole by one of its boxes. Rays
// find the same as through a new hierarchy, and visit more nodes the more the neighbourhood of primitives has
// changed. False, and nothing is changed, where a primitive that had no surface has one now: it isn't in the
// hierarchy. Throws as check_hierarchy() does for the layout's space.
template <class Stored>
bool refit_hierarchy(const SceneView<Stored>& scene, const GridLayout& layout, Structure& hierarchy);

} // namespace masu
