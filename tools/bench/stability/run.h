// Running sweeps: tracing their rays in every way, and judging what was found.
#pragma once

#include "libgrid/file/grid_file.h"
#include "tools/bench/stability/sweep.h"
#include "tools/bench/stability/tally.h"

#include <functional>

namespace masu::stability {

// A way to trace. `study`: robust arithmetic that ends with the first cell where anything is hit.
struct Way {
  const char* name;
  Precision precision;
  StopRule stop;
};
inline constexpr Way fast{"fast", Precision::fast, StopRule::proven},
    first_cell{"first-cell", Precision::robust, StopRule::first_cell},
    robust{"robust", Precision::robust, StopRule::proven},
    doubled{"double", Precision::doubled, StopRule::proven};
inline constexpr std::array all_ways{fast, first_cell, robust, doubled};

// One step of a sweep, traced in one way.
struct Row {
  std::string sweep, knob;
  double step;
  Way way;
  bool float64;  // the store
  bool promised; // robust or double: it must not fail
  bool within;   // and tells most rays' answer: the step is within its envelope
  Tally tally;
};

struct RunSettings {
  std::size_t rays = 1000; // a step, times the sweep's share
  std::uint64_t seed = 1;
};

// Every step, in every way that its store and its judge know; each row is told when it is there.
void run(const Sweep& sweep, const RunSettings& settings, const std::function<void(const Row&)>& tell);

// What rays find through a grid file, in one way, on the CPU.
std::vector<Found> found_through(const SceneFile& scene, const GridFile& grid,
                                 std::span<const ListedRay> rays, const Way& way);

// What is allowed to arithmetic of a precision, on primitives within `bounds`: that of robust for fast and
// study too.
double slack_for(Precision precision, const Boxd& bounds);
double unit_roundoff_of(Precision precision);

} // namespace masu::stability
