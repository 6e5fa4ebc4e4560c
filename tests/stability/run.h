// Runs sweeps: traces their rays in every mode, and compares the results with the oracle's.
#pragma once

#include "libgrid/file/structure_file.h"
#include "stability/oracle/disagreement.h"
#include "stability/sweeps/sweep.h"
#include "stability/tally.h"

#include <functional>

namespace masu::stability {

// embree: as it is by default; embree_robust: with RTC_SCENE_FLAG_ROBUST.
enum class Implementation { masu, embree, embree_robust };

// A precision and a stop rule; Embree is judged by robust's error bound.
struct Mode {
  const char* name;
  Precision precision;
  StopRule stop;
  Implementation by = Implementation::masu;
};
inline constexpr Mode fast{"fast", Precision::fast, StopRule::proven},
    first_cell{"first-cell-hit", Precision::robust, StopRule::first_cell},
    robust{"robust", Precision::robust, StopRule::proven},
    embree{"embree", Precision::robust, StopRule::proven, Implementation::embree},
    embree_robust{"embree-robust", Precision::robust, StopRule::proven, Implementation::embree_robust},
    doubled{"double", Precision::doubled, StopRule::proven};

// Results of one step of a sweep in one mode.
struct Row {
  std::string sweep, parameter;
  double step;
  Mode mode;
  bool float64;  // the store
  bool promised; // robust or double, proven, by Masu: no ray may fail
  bool within;   // promised, and the step is within its envelope: most rays must be sure
  Tally tally;
  // embree-robust: of robust and embree-robust, where exact hits are available.
  std::optional<Disagreement> disagreement{};
};

struct RunSettings {
  std::size_t rays = 1000; // per step, times the sweep's share
  std::uint64_t seed = 1;
  bool embree = false; // also in Embree: closest hits among triangles alone, float32 store
};

// Runs every step in every mode that its store and judge allow, and reports each row.
void run(const Sweep& sweep, const RunSettings& settings, const std::function<void(const Row&)>& report);

// Closest hits of rays through a grid file in one mode, on the CPU.
std::vector<Found> found_through(const SceneFile& scene, const StructureFile& grid,
                                 std::span<const Ray<double>> rays, const Mode& mode);

// The error bound of a precision for primitives within `bounds`; that of robust for fast, too.
double slack_for(Precision precision, const Boxd& bounds);
double unit_roundoff_of(Precision precision);

} // namespace masu::stability
