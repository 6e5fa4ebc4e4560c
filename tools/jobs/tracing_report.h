// What a run of gridrender or gridtrace took, of all its tasks and ranks together.
#pragma once

#include "renderer/counts.h"
#include "renderer/picture_warps.h"
#include "renderer/view_precision.h"
#include "tools/jobs/ranks.h"

#include <optional>
#include <span>

namespace masu {

// What was traced, as it is summed up in the end.
struct TaskTotals {
  std::uint64_t rays = 0;
  std::uint64_t invalid = 0; // of a list
  Counts counts;
};

// Calls act(a's number, b's) for each of them.
template <class A, class B, class Act>
void for_each_total(A& a, B& b, const Act& act) {
  act(a.rays, b.rays);
  act(a.invalid, b.invalid);
  for_each_count(a.counts, b.counts, act);
}

inline TaskTotals& operator+=(TaskTotals& a, const TaskTotals& b) {
  for_each_total(a, b, [](std::uint64_t& sum, std::uint64_t total) { sum += total; });
  return a;
}

// Seconds of tracing overlap those of writing, and those of several devices each other.
struct TracingReport {
  TaskTotals totals;
  std::uint64_t views = 0; // that were traced; 0: a list
  TraceSeconds seconds;
  double write_seconds = 0;
  double elapsed_seconds = 0;   // from the first ray to the last byte
  WarpTurns warps{};            // of the channel idle
  bool overlaps_writing = true; // else rays are traced in seconds.trace, and nothing is done besides

  // Of --resume: so many of the files that were asked for were there and are kept.
  std::uint64_t files = 0, kept = 0;

  // Of pictures with Precision::automatic: how many views were traced in double, and why a view was, if any
  // of this process.
  std::uint64_t double_views = 0;
  std::optional<ViewPrecision> precision{};
};

// Collective: adds the ranks' seconds and totals.
inline void sum_up(Ranks& ranks, TracingReport& report) {
  for_each_total(report.totals, report.totals,
                 [&](std::uint64_t& total, std::uint64_t) { ranks.sum(std::span(&total, 1)); });
  for (double* const seconds :
       {&report.seconds.upload, &report.seconds.trace, &report.seconds.download, &report.write_seconds})
    ranks.sum(std::span(seconds, 1));
}

} // namespace masu
