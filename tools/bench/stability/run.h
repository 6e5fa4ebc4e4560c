// Runs sweeps: traces their rays in every mode, and compares the results with the oracle's.
#pragma once

#include "libgrid/file/grid_file.h"
#include "tools/bench/stability/sweep.h"
#include "tools/bench/stability/tally.h"

#include <functional>

namespace masu::stability {

// A precision and a stop rule.
struct Mode {
  const char* name;
  Precision precision;
  StopRule stop;
};
inline constexpr Mode fast{"fast", Precision::fast, StopRule::proven},
    first_cell{"first-cell-hit", Precision::robust, StopRule::first_cell},
    robust{"robust", Precision::robust, StopRule::proven},
    doubled{"double", Precision::doubled, StopRule::proven};
inline constexpr std::array all_ways{fast, first_cell, robust, doubled};

// Results of one step of a sweep in one mode.
struct Row {
  std::string sweep, parameter;
  double step;
  Mode mode;
  bool float64;  // the store
  bool promised; // robust or double, proven: no ray may fail
  bool within;   // promised, and the step is within its envelope: most rays must be sure
  Tally tally;
};

struct RunSettings {
  std::size_t rays = 1000; // per step, times the sweep's share
  std::uint64_t seed = 1;
};

// Runs every step in every mode that its store and judge allow, and reports each row.
void run(const Sweep& sweep, const RunSettings& settings, const std::function<void(const Row&)>& report);

// Closest hits of rays through a grid file in one mode, on the CPU.
std::vector<Found> found_through(const SceneFile& scene, const GridFile& grid,
                                 std::span<const Ray<double>> rays, const Mode& mode);

// The error bound of a precision for primitives within `bounds`; that of robust for fast, too.
double slack_for(Precision precision, const Boxd& bounds);
double unit_roundoff_of(Precision precision);

} // namespace masu::stability
