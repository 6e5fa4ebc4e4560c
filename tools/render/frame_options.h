// Options of camera rays.
#pragma once

#include "renderer/tracer/tracer.h"
#include "tools/common/cli.h"

#include <optional>
#include <string>

namespace masu {

// Where the camera is, how pixels are sampled, which rays are spawned.
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
