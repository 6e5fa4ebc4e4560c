// What a run of gridrender took, of all its tasks and ranks together.
#pragma once

#include "renderer/tracer.h"
#include "tools/task_list.h"

namespace masu {

// Seconds of tracing overlap those of writing, and those of several devices each other.
struct TracingReport {
  TaskTotals totals;
  std::uint64_t tasks = 0;
  TraceSeconds seconds;
  double write_seconds = 0;
  double elapsed_seconds = 0; // from the first ray to the last byte
};

// Collective: adds the ranks' seconds and totals.
void sum_up(Ranks& ranks, TracingReport& report);

} // namespace masu
