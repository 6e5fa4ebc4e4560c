// A binary bounding volume hierarchy of high quality (fragment_split.h), depth first on the host: the same as
// of spatial_split_passes.h, but for the numbers of nodes.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"
#include "libscene/mesh/meshes_view.h"
#include "libscene/passes/host_executor.h"

namespace masu {

// From the top down, by the surface area heuristic over bins (Wald, "On Fast Construction of SAH-based
// Bounding Volume Hierarchies", RT 2007), with what the leaves hold of primitives divided further at planes
// where boxes would overlap (Stich, Friedrich & Dietrich, "Spatial Splits in Bounding Volume Hierarchies",
// HPG 2009). Boxes contain `margin` around each primitive. No more than max_hierarchy_depth nodes deep.
// Scene: SceneView or MeshesView. `progress` gets shares of the work.
template <class Scene>
BinaryHierarchy<TbbExecutor> binary_hierarchy(const Scene& scene, double margin, HostArray<BinaryNode> leaves,
                                              ProgressMonitor* progress);

// Enough bytes per primitive for the binary hierarchy and what it is made into.
inline constexpr double hierarchy_bytes_per_primitive = 300;

} // namespace masu
