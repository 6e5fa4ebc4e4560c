// Binary bounding volume hierarchies, depth first on the host: the same as by passes, but for the numbers of
// nodes.
#pragma once

#include "libgrid/hierarchy/binary/large_leaves.h"
#include "libscene/mesh/stored_triangles.h"
#include "libscene/passes/host_executor.h"

#include <functional>

namespace masu {

using HostHierarchy = BinaryHierarchy<TbbExecutor>;
using Leaves = HostArray<BinaryNode>;

// One of high quality (fragment_split.h; spatial_split_passes.h), from the top down, by the surface area
// heuristic over bins (Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007), with
// what the leaves hold of primitives divided further at planes where boxes would overlap (Stich, Friedrich &
// Dietrich, "Spatial Splits in Bounding Volume Hierarchies", HPG 2009). Boxes contain `margin` around each
// primitive. No more than max_hierarchy_depth nodes deep. Scene: SceneView or MeshesView. `progress` gets
// shares of the work.
template <class Scene>
HostHierarchy binary_hierarchy(const Scene& scene, double margin, Leaves leaves, ProgressMonitor* progress);

// Of an index.
using TriangleOf = std::function<Triangle<double>(PrimitiveIndex)>;

// One that is fast to build (leaf_split.h, large_leaves.h; top_down_passes.h). What leaves are many is split
// by all cores; then each range by one of them, depth first, in its cache. Leaves are partitioned as records,
// and nothing is gathered from elsewhere. They are sorted anew; `space`: where they are. Looks at `progress`
// every some thousand leaves.
HostHierarchy top_down_hierarchy(HierarchyLeaves<TbbExecutor> leaves, const TriangleOf& triangle,
                                 const Boxd& space, const ProgressMonitor* progress);

} // namespace masu
