// Measuring one way to trace a scene: its speed, and how far its hits and its picture are from those of brute
// force in double.
#pragma once

#include "tools/bench/tradeoff.h"

#include <optional>

namespace masu {

// What every configuration of a scene is asked, and the right answers.
struct TradeoffTask {
  TradeoffTask(const SceneFile& scene_, const TradeoffSetup& setup_);

  const SceneFile& scene;
  const TradeoffSetup& setup;
  std::vector<ListedRay> primary, random;
  Camera picture;

  // Answers by brute force, when first asked for: it takes a while.
  struct Truth {
    std::vector<ListedRay> rays; // spread evenly over both sets
    std::vector<HitRecord> hits; // by primitive
    std::vector<Vec3f> radiance;
  };
  const Truth& truth();

private:
  std::optional<Truth> truth_;
};

// The grid is of the task's scene. Throws Error(device).
Measurement measure(TradeoffTask& task, const GridFile& grid, const Configuration& configuration);

} // namespace masu
