// Hierarchies that are made on a CUDA device to be traced there. CUDA sources only.
#pragma once

#include "libgrid/structure/structure.h"
#include "libscene/cuda/device_memory.h"

namespace masu {

// Of HierarchyQuality::fast, the same bytes as build_hierarchy() makes (hierarchy_builder.h), of a scene in
// memory of the GPU, in this pool. Throws as that does, and Error(device).
template <class Stored>
StructureIn<CudaMemory> fast_hierarchy(const SceneView<Stored>& scene, const GridLayout& layout,
                                       cudaMemPool_t pool, int gpu, const ProgressMonitor* progress);

// Vertices in the world, where a pass sees them (libscene/mesh/stored_triangles.h).
template <class Number>
struct WorldVertices;

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
                                       const WorldVertices<Number>& vertices, cudaMemPool_t pool, int gpu);

} // namespace masu
