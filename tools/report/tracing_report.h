// What a run of gridrender or gridtrace took, of all its tasks and ranks together.
#pragma once

#include "renderer/picture_warps.h"
#include "renderer/view_precision.h"
#include "tools/jobs/task_list.h"

#include <optional>

namespace masu {

// Seconds of tracing overlap those of writing, and those of several devices each other.
struct TracingReport {
  TaskTotals totals;
  std::uint64_t views = 0; // 0: a list
  TraceSeconds seconds;
  double write_seconds = 0;
  double elapsed_seconds = 0;   // from the first ray to the last byte
  WarpTurns warps{};            // of the channel idle
  bool overlaps_writing = true; // else rays are traced in seconds.trace, and nothing is done besides

  // Of pictures with Precision::automatic: how many views were traced in double, and why a view was, if any
  // of this process.
  std::uint64_t double_views = 0;
  std::optional<ViewPrecision> precision{};
};

// Collective: adds the ranks' seconds and totals.
void sum_up(Ranks& ranks, TracingReport& report);

} // namespace masu
