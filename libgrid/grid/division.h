// The space that is divided, and into how many voxels.
#pragma once

#include "libgrid/grid/grid_layout.h"
#include "libgrid/grid/overlap/overlap.h"
#include "libscene/geometry/margin.h"
#include "libscene/scene_view.h"

#include <string>
#include <string_view>

namespace masu {

enum class SpaceRule { tight, cube };

// With N primitives in a space of sides w and volume V:
//   fixed          the numbers given
//   cube_root      each axis D·∛N
//   woo            the longest axis D·∛N, the others in proportion (Woo)
//   heterogeneous  an axis D·w·∛(N/V)
//                  (Klimaszewski & Sederberg, "Faster Ray Tracing Using Adaptive Grids", IEEE CG&A 17(1),
//                  1997)
//   cleary         an axis w·∛(λN/V): λN voxels of equal sides
//                  (Cleary & Wyvill, The Visual Computer 4(2), 1988)
//   automatic      cleary with the smallest λ that the cost model below puts within a few percent of the best
//   nested         cleary for voxels that will be divided further: λ is from 0.05 to 1, the larger the more
//                  of the space lies beyond where most primitives are; or, if that is more, 32 times the
//                  cones' share of the primitives
// The last two are no finer than largest_division, most_references() and most_nested_references() allow.
struct DivisionRule {
  enum class Kind { fixed, cube_root, woo, heterogeneous, cleary, automatic, nested } kind = Kind::automatic;
  Vec3i fixed{1, 1, 1};
  double parameter = 0; // D or λ
  std::string text = "auto";
};

// The most voxels along an axis.
inline constexpr std::int32_t largest_division = 65535;

// Reads `auto`, `N`, `NXxNYxNZ`, `cube-root:D`, `woo:D`, `heterogeneous:D`, `cleary:L`. Throws Error(usage).
DivisionRule parse_division(std::string_view text);

// Sums over primitives: of their extent along each axis, and of their surface's projection along it (both
// sides of a sphere or cone count).
struct SurfaceSums {
  std::uint64_t primitives = 0;
  Vec3d extents{};
  Vec3d projections{};
};

// What the cost of a division depends on. `dense_box` holds the middle nine tenths of the primitives, axis by
// axis: where most rays will find something to do, however far a floor reaches beyond it.
struct DivisionStatistics {
  SurfaceSums all, dense; // dense: those whose box is centred in `dense_box`
  Boxd dense_box{};
  double cone_share = 0; // of all primitives
};

template <class Stored>
DivisionStatistics division_statistics(const SceneView<Stored>& scene);

// About how many references the primitives make under the exact overlap test: a convex piece of surface,
// placed at random, meets as many voxels as its Minkowski sum with one holds by volume. With the margin, a
// voxel is larger by it on either side.
double expected_references(const SurfaceSums& sums, const GridLayout& layout);

// Half the surface of a box of these sides; a ratio of two is that of their surfaces.
inline double half_area(const Vec3d& w) {
  return w.x * w.y + w.y * w.z + w.z * w.x;
}
// The voxels of a space of these sides that a random line meets: each plane of the division is crossed with
// the probability of its two faces over the space's surface (Crofton).
inline double expected_voxels(const Vec3i& n, const Vec3d& w) {
  return 1 + ((n.x - 1) * w.y * w.z + (n.y - 1) * w.z * w.x + (n.z - 1) * w.x * w.y) / half_area(w);
}

// How many references a division that nobody gave may make: more than scenes need, whose references take
// about eight times a hierarchy's memory and time. Without a limit, large primitives that lie on each other
// would be divided for the last percents of the expected cost. It depends on the scene alone: so the grid is
// the same on any machine. Voxels that will be divided further make far fewer.
double most_references(std::uint64_t primitives);
double most_nested_references(std::uint64_t primitives);

// The box that is divided, its padding included, in numbers that Real holds: the tight one around `bounds`
// (that of all primitives), or the smallest cube about the local origin that holds it.
template <class Real>
Boxd space_of(const Boxd& bounds, SpaceRule rule) {
  Boxd space = padded_bounds<Real>(bounds);
  if (rule == SpaceRule::cube) {
    const double half = largest_magnitude(space);
    space = {{-half, -half, -half}, {half, half, half}};
  }
  return cast<double>(cast<Real>(space));
}

// That space divided into so many voxels, with the margin of libscene/geometry/margin.h.
template <class Real>
GridLayout layout_in(const Boxd& bounds, const Vec3i& division, SpaceRule rule = SpaceRule::tight) {
  return {space_of<Real>(bounds, rule), division, is_empty(bounds) ? 0 : rounding_margin<Real>(bounds)};
}

// At least 1 along each axis. Throws Error(usage, "division", …) when an axis would pass largest_division by
// a rule that was given.
Vec3i choose_division(const DivisionRule& rule, const DivisionStatistics& statistics, const Boxd& space,
                      double margin);

// The layout that a grid for arithmetic of type Real is built on.
template <class Real>
GridLayout make_grid_layout(const Boxd& bounds, SpaceRule space_rule, const DivisionRule& rule,
                            const DivisionStatistics& statistics) {
  GridLayout layout = layout_in<Real>(bounds, {1, 1, 1}, space_rule);
  layout.division = choose_division(rule, statistics, layout.space, layout.margin);
  return layout;
}

} // namespace masu
