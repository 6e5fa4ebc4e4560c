// A binary bounding volume hierarchy of high quality, built on the host.
#pragma once

#include "libgrid/hierarchy/collapse_passes.h"
#include "libscene/passes/host_executor.h"
#include "libscene/scene_view.h"

#include <cmath>

namespace masu {

// x, y, z, and a lane that boxes ignore: min and max of all four take an instruction.
using Lanes = float __attribute__((vector_size(16)));

inline Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}
inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}

struct LaneBox {
  Lanes low = {INFINITY, INFINITY, INFINITY, INFINITY};
  Lanes high = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

  void join(const LaneBox& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  // Half of the surface: what SAH compares.
  float area() const {
    const Lanes side = high - low;
    return side[0] * (side[1] + side[2]) + side[1] * side[2];
  }
};

// The bounds of a primitive, or of a part of it, the margin included; its index is in a lane that boxes
// ignore.
struct HierarchyFragment {
  LaneBox box;

  PrimitiveIndex primitive() const { return bits_of(box.low[3]); }
  // Twice the centre.
  Lanes centre() const { return box.low + box.high; }
};

// From the top down, by the surface area heuristic over bins (Wald, "On Fast Construction of SAH-based
// Bounding Volume Hierarchies", RT 2007), with what the leaves hold of primitives divided further at planes
// where boxes would overlap (Stich, Friedrich & Dietrich, "Spatial Splits in Bounding Volume Hierarchies",
// HPG 2009). Boxes contain `margin` around each primitive. No more than max_hierarchy_depth nodes deep.
// `progress` gets shares of the work.
template <class Stored>
BinaryHierarchy<TbbExecutor> binary_hierarchy(const SceneView<Stored>& scene, double margin,
                                              const HostArray<BinaryNode>& leaves, ProgressMonitor* progress);

// About how many bytes per primitive the binary hierarchy takes, and what it is made into.
inline constexpr double hierarchy_bytes_per_primitive = 300;

} // namespace masu
