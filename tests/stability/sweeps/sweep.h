// Sweeps: each varies one parameter over the range in which tracing begins to fail, and counts at every step
// the rays with correct results.
#pragma once

#include "libgrid/structure/builder.h"
#include "renderer/tracer/tracer.h"
#include "stability/test_scene.h"

#include <algorithm>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace masu::stability {

// Build options of a grid. Results must be independent of it.
struct StructureWanted {
  Vec3i division;
  StructureKind kind;
};

// Scene and rays of one step, rounded to the store, so that every precision traces the same.
template <class Stored>
struct Trial {
  TestScene<Stored> scene;
  std::vector<Ray<double>> rays;
  std::vector<StructureWanted> grids{{{7, 6, 5}, StructureKind::uniform},
                                     {{40, 33, 64}, StructureKind::uniform},
                                     {{3, 4, 2}, StructureKind::irregular},
                                     {{16, 16, 16}, StructureKind::x},
                                     {{1, 1, 1}, StructureKind::hierarchy}};
  std::vector<Vec3d> aims{}; // leaving: a random unit vector for each ray
  // leaving: the sine of each ray's angle to the surface that it leaves; none: not grazing
  std::vector<double> sines{};
  std::int32_t depth = 1; // glass: the largest depth of rays
  std::optional<TestScene<double>>
      original{}; // closest: the scene before rounding, with which hits are compared
};

// How a step's rays are checked.
//   closest     against the oracle's closest hit
//   enclosed    rays begin inside a closed mesh: a miss is a leak (missed)
//   leaving     two rays leave each hit. The outward one must not hit the convex body that it leaves (acne: a
//   false
//               hit); the inward one must hit something, since box and spheres are closed (a leak: missed)
//   glass       radiance is finite, and no greater than the light that comes in (otherwise wrong)
//   refraction  Snell's law: total reflection (missed: reflected in error; false hit: refracted in error),
//   and the
//               direction (misplaced), whose error takes the place of t's
enum class Judge { closest, enclosed, leaving, glass, refraction };

// The closed range of the parameter in which a precision not only never fails, but leaves at most half of the
// rays unsure. (The tolerance allows for the rounding of steps.)
struct Envelope {
  double from, to;
  bool holds(double parameter) const {
    return parameter >= from * (1 - 1e-9) && parameter <= to * (1 + 1e-9);
  }
};

inline constexpr Envelope everywhere{0, 1e300};

struct Sweep {
  std::string name;
  std::string parameter; // description
  Judge judge = Judge::closest;
  double share = 1;                                     // of the number of rays: sweeps differ in cost
  std::vector<double> float32_steps{}, float64_steps{}; // by store
  Trial<float> (*float32)(Chance& chance, double parameter, std::size_t rays) = nullptr;
  Trial<double> (*float64)(Chance& chance, double parameter, std::size_t rays) = nullptr; // may be null
  Envelope robust = everywhere, doubled = everywhere; // of the float32 store
  Envelope doubled64 = everywhere;                    // of the float64 store
  bool by_rule = false; // each step has the store that `--store auto` takes; trials have an `original`
};

// For GoogleTest's messages.
void PrintTo(const Sweep& sweep, std::ostream* out);

// All of them, in the order of docs/accuracy.md.
std::vector<Sweep> all_sweeps();

// A sweep's scenes and rays of triangles alone, which Embree can trace, too: NAME-triangles.
Sweep triangles_alone(Sweep sweep, decltype(Sweep::float32) triangles);

// Those of each source.
std::vector<Sweep> place_sweeps(); // position and size of the scene, origins of rays
std::vector<Sweep> shape_sweeps(); // shapes of primitives
std::vector<Sweep> grid_sweeps();  // rays and surfaces relative to voxels
std::vector<Sweep> body_sweeps();  // closed surfaces, and rays that leave them
std::vector<Sweep> store_sweeps(); // small parts, by the rule of the store

// The random numbers of a step, independent of which other steps are run.
Chance chance_for(std::uint64_t seed, std::string_view sweep, double parameter);

// Calls act(trial, step) for every step and store, with so many rays times the sweep's share.
template <class Act>
void for_each_trial(const Sweep& sweep, std::size_t rays, std::uint64_t seed, const Act& act) {
  const auto share = static_cast<std::size_t>(static_cast<double>(rays) * sweep.share);
  const auto each = [&](const std::vector<double>& steps, auto make, double sign) {
    for (const double step : steps) {
      Chance chance = chance_for(seed, sweep.name, sign * step);
      act(make(chance, step, std::max(std::size_t{1}, share)), step);
    }
  };
  each(sweep.float32_steps, sweep.float32, 1);
  each(sweep.float64_steps, sweep.float64, -1);
}

// --- Parts of trials ------------------------------------------------------------------------------------

// From one point towards another, rounded to the store. The direction's largest component is between 1 and 2;
// t counts in its length.
template <class Stored>
Ray<double> ray_towards(const Vec3d& from, const Vec3d& to);
// The same, in a direction.
template <class Stored>
Ray<double> ray_along(const Vec3d& from, const Vec3d& direction);

// Powers of ten, `by` exponents apart; and with 0 before them.
std::vector<double> powers_of_ten(int from, int to, int by = 1);
std::vector<double> zero_and_powers_of_ten(int from, int to, int by = 1);

// A point whose coordinates have no special binary representation.
inline constexpr Vec3d somewhere{0.8347, -1, 0.6113};

// What scenes are made of; triangles alone can be traced by Embree, too.
enum class Kinds { all, triangles };

// Random triangles, and spheres and cones of all kinds, within ±size of `at`.
template <class Stored>
TestScene<Stored> random_scene(Chance& chance, const Vec3d& at, double size, Kinds kinds = Kinds::all);

// Rays from outside and inside such a scene towards points in it.
template <class Stored>
std::vector<Ray<double>> rays_around(Chance& chance, const Vec3d& at, double size, std::size_t count);

// Adds a cone unless rounding makes its length zero.
template <class Stored>
void add_cone(TestScene<Stored>& scene, const Cone<Stored>& cone) {
  if (!(cone.base == cone.apex)) scene.add(cone);
}

} // namespace masu::stability
