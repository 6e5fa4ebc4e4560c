// The options that gridrender and gridtrace share: a scene and its grid, where and how rays are traced, the
// reports of it; and of camera rays.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tools/common/backend.h"

#include <optional>
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

// Of camera rays: where the camera is, how pixels are sampled, which rays are spawned.
struct FrameOptions {
  std::string size, from, at, up;
  std::optional<double> angle;
  Sampling sampling = Sampling::corners;
  int depth = 5;
  bool hither = false, spd_rules = false;

  void add_camera(const CommandLine& command);    // --size, --from, --at, --up, --angle
  void add_sampling(const CommandLine& command);  // --sampling, --hither
  void add_secondary(const CommandLine& command); // --depth, --spd-rules
  // The scene's, changed; whether it can see isn't checked. Throws Error(usage).
  Camera camera(const SceneFile& scene) const;
  // Throws Error(usage, option, …) for a camera that was changed and can't see.
  void check(const Camera& camera, const SceneFile& scene) const;
  // But for the camera.
  FrameRequest frame(const TracingRules& tracing) const;
};

} // namespace masu
