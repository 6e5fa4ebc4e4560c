// The options that gridrender and gridtrace share: a scene and its grid, where and how rays are traced, and
// the reports of it.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tools/common/backend.h"

#include <string>

namespace masu {

struct TracingOptions {
  std::string scene, grid, stats, times;
  Backend backend = Backend::automatic;
  std::string devices; // all, cpu, or numbers of GPUs
  TracingRules rules;  // but for `count`
  Threads threads;
  int repeat = 1;
  bool brute_force = false, quiet = false, resume = false;

  void add_files(const CommandLine& command); // SCENE, GRID
  void add_to(const CommandLine& command);    // all others
  // Throws Error(usage) where SCENE or GRID is missing, Error(input) where SCENE has to be converted first.
  void check(const char* tool) const;
  TracingRules tracing() const;
  // The file of --stats or --times, or empty.
  const std::string& report() const { return stats.empty() ? times : stats; }
};

// --hit-name. `what`: that it names.
void add_hit_name(const CommandLine& command, HitName& name, const std::string& what);

} // namespace masu
