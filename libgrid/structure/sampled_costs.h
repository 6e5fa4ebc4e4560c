// What a scene's rays cost through a grid or a hierarchy, found out by tracing some of them.
#pragma once

#include "libgrid/structure/structure.h"

namespace masu {

// Of the mean ray: cells or nodes visited, and primitives tested.
struct RayCost {
  double steps = 0, tests = 0;
};

// Of nearest hits: of rays between random points of the sphere around the scene; of rays from random points
// within its bounds to random primitives, as from cameras and antennas, which are turned to where there is
// something; of rays scattered diffusely from what those hit. All are zeros for a scene without primitives.
// They depend on the scene's geometry alone.
struct SampledCosts {
  RayCost across, aimed, scattered;
  std::size_t rays = 0;   // traced of each set
  std::uint64_t work = 0; // steps and tests of all
};

// How many rays of each set are traced; fewer once more than so many steps and tests have been made.
struct SampleLimits {
  std::size_t rays = 2048;
  std::uint64_t work = ~std::uint64_t{0};
};

// The grid is of the scene, of any kind, and its space no farther than a hierarchy's may be.
template <class Stored>
SampledCosts sampled_costs(const SceneView<Stored>& scene, const Structure& grid,
                           const SampleLimits& limits = {}, const ProgressMonitor* progress = nullptr);

// Whether rays may be faster through a grid than through a hierarchy of these costs, of which so many rays
// tell: where long primitives overlap, a ray that hits something tests many.
inline constexpr std::size_t rays_that_tell = 256;
bool grid_may_win(const SampledCosts& hierarchy);

// About how long rays take through a structure of the kind: the geometric mean of the sets, in steps to a
// cell of an irregular grid on that processor.
double expected_time(const SampledCosts& costs, StructureKind kind, Processor processor);

} // namespace masu
