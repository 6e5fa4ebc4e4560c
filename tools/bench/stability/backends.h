// The sweeps' rays on the CPU and on a GPU.
#pragma once

#include "tools/bench/stability/run.h"

namespace masu::stability {

// One step traced with one precision by both: how many rays' answers differ in any bit, in either loop.
struct Difference {
  std::string sweep;
  double step;
  Way way;
  bool float64;
  std::uint64_t rays, differing;
};

// Every step of the sweep through all its grids, whose files are in memory. Throws Error(device).
void compare_backends(const Sweep& sweep, const RunSettings& settings,
                      const std::function<void(const Difference&)>& tell);

} // namespace masu::stability
