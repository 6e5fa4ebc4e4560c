// The sweeps' rays on the CPU and on a GPU.
#pragma once

#include "stability/run.h"

namespace masu::stability {

// One step in one precision: the number of rays whose hits differ in any bit between CPU and GPU, summed over
// the GPU's loops and the step's grids.
struct Difference {
  std::string sweep;
  double step;
  Mode mode;
  bool float64;
  std::uint64_t rays, differing;
};

// Traces every step of the sweep through all its grids, and reports each step and precision. Throws
// Error(device).
void compare_backends(const Sweep& sweep, const RunSettings& settings,
                      const std::function<void(const Difference&)>& report);

} // namespace masu::stability
