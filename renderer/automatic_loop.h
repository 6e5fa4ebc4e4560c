// The loop by which a GPU traces a list of rays fastest, found out by tracing a few of them on the CPU.
#pragma once

#include "renderer/tracer.h"

#include <mutex>

namespace masu {

// What rays cost whose neighbours in the list share a warp: means over the warps of a sample. Steps are
// cells or nodes visited, and work is steps and tests.
struct WarpCosts {
  double work = 0, tests = 0;           // of the mean ray
  double most_work = 0, most_tests = 0; // of the warp's longest rays
};

// Of 2048 rays of a list in host memory; takes a core some milliseconds. Throws Error(usage) for rays that
// aren't there and a precision that doesn't hold the scene.
WarpCosts sampled_costs(const SceneFile& scene, const GridFile& grid, const RayList& rays, Query query,
                        Precision precision);

// The fastest loop for rays of such costs, or one within some per cent of it (docs/performance.md).
RayLoop automatic_loop(const WarpCosts& costs, bool is_hierarchy);

inline RayLoop automatic_loop(const SceneFile& scene, const GridFile& grid, const RayList& rays, Query query,
                              Precision precision) {
  return automatic_loop(sampled_costs(scene, grid, rays, query, precision), grid.is_hierarchy());
}

// The loops for rays that can't be looked at, because they are in a GPU's memory: that of the scene's camera
// rays where neighbours are said to be coherent, else that of random rays through the scene's bounds. Found
// out when first asked for. For threads at the same time.
class UsualLoops {
public:
  RayLoop of(const SceneFile& scene, const GridFile& grid, bool coherent);

private:
  struct Usual {
    std::once_flag once;
    RayLoop loop = RayLoop::warp_refill;
  } coherent_, incoherent_;
};

} // namespace masu
