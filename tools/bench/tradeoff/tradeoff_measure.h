// Measures one configuration: its speed, and the errors of its hits and picture compared with brute force in
// double.
#pragma once

#include "tools/bench/tradeoff/tradeoff.h"

namespace masu {

// The rays and the picture that every configuration of a scene traces, and the reference results.
struct TradeoffTask {
  // Traces the reference by brute force in double, which is slow. Both outlive it.
  TradeoffTask(const SceneFile& scene_, const TradeoffSetup& setup_);

  const SceneFile& scene;
  const TradeoffSetup& setup;
  std::vector<Ray<double>> primary, random;
  Camera picture;
  struct Reference {
    std::vector<Ray<double>> rays; // evenly spaced in both sets
    std::vector<HitRecord> hits;   // by primitive
    HostArray<Vec3f> radiance;
  } reference;
};

// The grid is of the task's scene. Throws Error(device).
Measurement measure(const TradeoffTask& task, const StructureFile& grid, const Configuration& configuration);

} // namespace masu
