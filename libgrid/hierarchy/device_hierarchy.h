// Hierarchies that are made on a CUDA device to be traced there. CUDA sources only.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/structure/structure_records.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/cuda/device_memory.h"
#include "libscene/scene_view.h"

namespace masu {

// Of HierarchyQuality::fast, the same bytes as build_hierarchy() makes (hierarchy_builder.h).
struct BuiltHierarchy {
  DeviceArray<HierarchyNode> nodes;
  DeviceArray<PrimitiveIndex> references;
};

// Of a scene in memory of the GPU, in this pool. Throws as build_hierarchy() does, and Error(device).
template <class Stored>
BuiltHierarchy fast_hierarchy(const SceneView<Stored>& scene, const GridLayout& layout, cudaMemPool_t pool,
                              int gpu, const ProgressMonitor* progress);

// Vertices in the world, where a pass sees them (libscene/mesh/move_passes.h).
template <class Number>
struct MovedVertices;

// With its scene's triangles.
template <class Stored>
struct MovedHierarchy {
  DeviceArray<Triangle<Stored>> triangles;
  DeviceArray<HierarchyNode> nodes;
  Boxd bounds; // of the whole scene, relative to its origin
};

// All in memory of the GPU, and the results in this pool; for a pass on its default stream, which is waited
// for. No nodes, where a triangle has an area that had none: the hierarchy doesn't refer to it. Throws as
// moved_triangles() does, and Error(usage, "vertices", …) for a scene that reaches farther than a hierarchy.
template <class Stored, class Number>
MovedHierarchy<Stored> moved_hierarchy(const SceneView<Stored>& scene, const StructureRecords& hierarchy,
                                       const MovedVertices<Number>& vertices, cudaMemPool_t pool, int gpu);

} // namespace masu
