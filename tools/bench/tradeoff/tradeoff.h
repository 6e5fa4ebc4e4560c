// What `gridbench tradeoff` measures: one row for each scene, setup and configuration.
#pragma once

#include "libgrid/structure/chosen_structure.h"
#include "renderer/tracer/tracer.h"

#include <string>

namespace masu {

// What all rows of a chart have in common: rows of different setups can't be compared.
struct TradeoffSetup {
  std::string backend;        // cpu, cuda
  std::uint64_t threads = 0;  // of the CPU; 0 for cuda
  std::string size;           // of the primary rays, WxH
  std::uint64_t random = 0;   // random rays
  std::uint64_t compared = 0; // rays of each of the two sets that are compared with brute force (upper limit)
  std::string picture;        // its size, WxH
  std::uint64_t seed = 0;     // of the random rays
  std::uint64_t repeat = 0;   // timed runs; their median counts, on a CPU of processor time
  friend bool operator==(const TradeoffSetup&, const TradeoffSetup&) = default;
};

// A precision, a stop rule and a grid's build options. `merge` isn't `automatic`, which is one of the others.
struct Configuration {
  Precision precision;
  StopRule stop;
  StructureKind merge;
  std::string division; // as gridbuild takes it
  Overlap overlap;
  friend bool operator==(const Configuration&, const Configuration&) = default;
};

// Compared with brute force in double.
struct Accuracy {
  std::uint64_t rays = 0;             // compared
  std::uint64_t missed = 0;           // no hit found where there is one
  std::uint64_t false_hits = 0;       // a hit found where there is none
  std::uint64_t wrong_primitives = 0; // a hit of another primitive, at another t
  std::uint64_t ties = 0;           // another primitive at the same t to within float32's rounding: not wrong
  double worst_t = 0, median_t = 0; // relative errors of t of correct hits, which are float32: errors below
                                    // 2^-24 read 0
  double rmse = 0, largest = 0;     // of the picture's channels (linear)

  std::uint64_t wrong() const { return missed + false_hits + wrong_primitives; }
};

struct Measurement {
  std::uint64_t voxels = 0; // of the division
  std::uint64_t grid_bytes = 0, scene_bytes = 0;
  double primary_mrays = 0, random_mrays = 0, mrays = 0; // million closest hits a second; mrays: of both sets
  double picture_ms = 0;
  Accuracy accuracy;
};

struct TradeoffRow {
  std::string scene, scene_hash;
  TradeoffSetup setup;
  Configuration configuration;
  Measurement measured;
};

// The names used in the table and the file: proven, first-cell-hit of a StopRule; none, x, balance,
// irregular, bvh of a StructureKind; box, exact of an Overlap.
template <class Value>
const char* name_of(Value value);
// The Precision, StopRule, StructureKind or Overlap of that name. Throws Error(usage, text, …).
template <class Value>
Value named(const std::string& text);

// Precision and stop rule: a series of the charts.
std::string method_of(const Configuration& configuration);
// Merge mode, division and overlap test.
std::string grid_of(const Configuration& configuration);

} // namespace masu
