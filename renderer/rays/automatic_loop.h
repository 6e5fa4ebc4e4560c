// The loop by which a GPU traces a list of rays fastest: through a hierarchy chosen on the GPU
// (renderer/cuda/rays/loop_choice.h), through a grid found out by tracing a few of them.
#pragma once

#include "renderer/tracer/tracer.h"

#include <atomic>

namespace masu {

// What rays cost whose neighbours in the list share a warp: means over the warps of a sample. Steps are
// cells or nodes visited, and work is steps and tests.
struct WarpCosts {
  double work = 0, tests = 0;           // of the mean ray
  double most_work = 0, most_tests = 0; // of the warp's longest rays
};

// Of 2048 rays of a list in host memory, counted where the tracer traces: well below a millisecond on a GPU.
// The tracer has a grid. Throws Error(usage) for rays that aren't there and a precision that doesn't hold the
// scene, Error(device).
WarpCosts warp_costs(const ResidentTracer& tracer, const RayList& rays, Query query, Precision precision);

// Through a grid the fastest loop for rays of such costs, or one within some per cent of it
// (docs/algorithm.md).
RayLoop automatic_loop(const WarpCosts& costs, Query query);

inline RayLoop automatic_loop(const ResidentTracer& tracer, const RayList& rays, Query query,
                              Precision precision) {
  if (tracer.is_hierarchy()) return RayLoop::automatic;
  return automatic_loop(warp_costs(tracer, rays, query, precision), query);
}

// The loops through a grid of rays that can't be looked at, because they are in a GPU's memory: that of the
// scene's camera rays where neighbours are said to be coherent, else that of random rays through the scene's
// bounds. Found out when first asked for; by each of several threads that ask at once, rather than that one
// waits for another, which may be a task that waits for it. They all find the same.
struct UsualLoops {
  // By whether neighbours are coherent; automatic: not known yet.
  std::atomic<RayLoop> usual[2] = {RayLoop::automatic, RayLoop::automatic};

  RayLoop of(const ResidentTracer& tracer, bool coherent);
};

} // namespace masu
