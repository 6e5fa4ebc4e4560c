// What `gridbench tradeoff` measures: one row a scene, setup and configuration.
#pragma once

#include "libgrid/build/recipe.h"
#include "renderer/tracer.h"

#include <string>
#include <vector>

namespace masu {

// What is the same for all rows of a chart: rows of another setup can't be compared.
struct TradeoffSetup {
  std::string backend;        // cpu, cuda
  std::uint64_t threads = 0;  // of the CPU; of cuda 0
  std::string size;           // of the primary rays, WxH
  std::uint64_t random = 0;   // random rays
  std::uint64_t compared = 0; // rays of each of the two sets that are compared with brute force, at most
  std::string picture;        // its size, WxH
  std::uint64_t seed = 0;     // of the random rays
  std::uint64_t repeat = 0;   // the median of so many runs
  friend bool operator==(const TradeoffSetup&, const TradeoffSetup&) = default;
};

// One way to trace. `merge` isn't automatic: that is one of the others.
struct Configuration {
  Precision precision;
  StopRule stop;
  MergeChoice merge;
  std::string division; // as gridbuild takes it
  Overlap overlap;
  friend bool operator==(const Configuration&, const Configuration&) = default;
};

// How far from brute force in double.
struct Accuracy {
  std::uint64_t rays = 0;                                         // compared
  std::uint64_t missed = 0, false_hits = 0, wrong_primitives = 0; // hits: none found, none there, another's
  std::uint64_t ties = 0; // another primitive in the same place to within float32's rounding: not wrong
  double worst_t = 0, median_t = 0; // relative error of t where the hit is right; reported as float32, so
                                    // that errors below 2^-24 read 0
  double rmse = 0, largest = 0;     // of the picture's channels, as linear light

  std::uint64_t wrong() const { return missed + false_hits + wrong_primitives; }
};

struct Measurement {
  std::uint64_t voxels = 0; // of the division
  std::uint64_t grid_bytes = 0, scene_bytes = 0;
  double primary_mrays = 0, random_mrays = 0, mrays = 0; // million nearest hits a second; of both sets
  double picture_ms = 0;
  Accuracy accuracy;
};

struct TradeoffRow {
  std::string scene, scene_hash;
  TradeoffSetup setup;
  Configuration configuration;
  Measurement measured;
};

// In words, as the table and the file have them.
const char* name_of(StopRule stop);     // proven, first-cell-hit
const char* name_of(MergeChoice merge); // none, x, balance, irregular
const char* name_of(Overlap overlap);   // box, exact
// Throw Error(usage, text, …).
Precision precision_named(const std::string& text);
StopRule stop_named(const std::string& text);
MergeChoice merge_named(const std::string& text);
Overlap overlap_named(const std::string& text);

// The precision, and whether rays end with the first cell's hit: a chart's series.
std::string method_of(const Configuration& configuration);
// The grid: merge mode, division, overlap test.
std::string grid_of(const Configuration& configuration);

} // namespace masu
