// A binary hierarchy from the root down (leaf_split.h, large_leaves.h) on the host: the same as of
// top_down_passes.h, but for the numbers of nodes.
//
// What leaves are many is split by all cores; then each range by one of them, depth first, in its cache.
// Leaves are partitioned as records, and nothing is gathered from elsewhere.
#pragma once

#include "libgrid/hierarchy/binary/large_leaves.h"
#include "libscene/passes/host_executor.h"

#include <functional>

namespace masu {

// Of an index.
using TriangleOf = std::function<Triangle<double>(PrimitiveIndex)>;

// Leaves are sorted anew; `space`: where they are. Looks at `progress` every some thousand leaves.
BinaryHierarchy<TbbExecutor> top_down_hierarchy(HierarchyLeaves<TbbExecutor> leaves,
                                                const TriangleOf& triangle, const Boxd& space,
                                                const ProgressMonitor* progress);

} // namespace masu
