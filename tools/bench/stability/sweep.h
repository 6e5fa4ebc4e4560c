// Sweeps: each turns one knob through the range where ways to trace break, and asks at every step how many
// rays find what they should.
#pragma once

#include "libgrid/build/build.h"
#include "renderer/tracer.h"
#include "tools/bench/stability/test_scene.h"

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace masu::stability {

// A grid that must not show.
struct GridWanted {
  Vec3i division;
  Merge merge;
};

// What one step traces. Scene and rays hold numbers of the store, so that every arithmetic is given the same.
template <class Stored>
struct Trial {
  TestScene<Stored> scene;
  std::vector<ListedRay> rays;
  std::vector<GridWanted> grids{{{7, 6, 5}, Merge::none},
                                {{40, 33, 64}, Merge::none},
                                {{3, 4, 2}, Merge::irregular},
                                {{16, 16, 16}, Merge::x}};
  std::vector<Vec3d> aims{}; // leaving: for each ray a unit vector by chance
  std::int32_t depth = 1;    // glass: of the last ray
};

// How a step's rays are judged.
//   closest   by the oracle's closest hit
//   enclosed  rays begin inside a closed mesh: one that hits nothing is a leak (missed)
//   leaving   from what each ray hits two more leave. The one outwards must not meet the convex body it
//   leaves
//             (acne: a false hit); the one inwards must meet something, since box and spheres are closed (a
//             leak: missed)
//   glass     radiance: finite, and no more than what shines in (wrong otherwise)
//   refraction  Snell's law: total reflection where it should be (missed: total, but shouldn't be; a false
//   hit:
//             the other way round), and the direction (misplaced), whose error stands in t's place
enum class Judge { closest, enclosed, leaving, glass, refraction };

// The knob's values, both included, between which a precision not only never fails, but leaves no more than
// half of the rays in doubt. (Steps are computed: the bounds give way to their rounding.)
struct Envelope {
  double from, to;
  bool holds(double knob) const { return knob >= from * (1 - 1e-9) && knob <= to * (1 + 1e-9); }
};

struct Sweep {
  const char* name;
  const char* knob; // in words
  Judge judge;
  double share;                                     // of the usual number of rays: some are cheap, some dear
  std::vector<double> float32_steps, float64_steps; // by store
  Trial<float> (*float32)(Chance& chance, double knob, std::size_t rays);
  Trial<double> (*float64)(Chance& chance, double knob, std::size_t rays); // may be null
  Envelope robust, doubled;                                                // of the float32 store
  Envelope doubled64;                                                      // of the float64 store
};

// How tests name it.
void PrintTo(const Sweep& sweep, std::ostream* out);

// All of them, in the order of docs/stability.md.
std::vector<Sweep> all_sweeps();

// Those of each source.
std::vector<Sweep> place_sweeps(); // where the scene and the eye are
std::vector<Sweep> shape_sweeps(); // what the primitives look like
std::vector<Sweep> grid_sweeps();  // how rays and surfaces lie to the voxels
std::vector<Sweep> body_sweeps();  // closed surfaces, and what leaves them

inline constexpr Envelope everywhere{0, 1e300};

// A step's own chance, whichever other steps are run.
Chance chance_for(std::uint64_t seed, std::string_view sweep, double knob);

// --- What trials are made of -----------------------------------------------------------------------------

// From one point towards another, in numbers of the store. The direction's largest component is between 1
// and 2: t counts in that length.
template <class Stored>
ListedRay ray_towards(const Vec3d& from, const Vec3d& to);
// The same, along a direction.
template <class Stored>
ListedRay ray_along(const Vec3d& from, const Vec3d& direction);

// Powers of ten, `by` exponents apart.
std::vector<double> powers_of_ten(int from, int to, int by = 1);

// Triangles, spheres and cones by chance, within ±size of `at`.
template <class Stored>
TestScene<Stored> mixed_scene(Chance& chance, const Vec3d& at, double size);

// From around such a scene, and from within, towards places in it.
template <class Stored>
std::vector<ListedRay> rays_around(Chance& chance, const Vec3d& at, double size, std::size_t count);

// Adds a cone unless rounding leaves it no length.
template <class Stored>
void add_cone(TestScene<Stored>& scene, const Cone<Stored>& cone) {
  if (!(cone.base == cone.apex)) scene.cones.push_back(cone);
}

} // namespace masu::stability
