#include "libgrid/grid/division.h"

#include "libgrid/structure/unit_costs.h"
#include "libscene/base/error.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace masu {
namespace {

[[noreturn]] void fail(std::string_view text, std::string_view why) {
  throw Error(ErrorCode::usage, "division",
              fmt::format("'{}' {}: give N, NXxNYxNZ, cube-root:D, woo:D, heterogeneous:D, cleary:L or auto",
                          text, why));
}

template <class Number>
Number number_in(std::string_view digits, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) fail(text, "isn't a division");
  return value;
}

Vec3i fixed_division(std::string_view text) {
  Vec3i division{};
  std::string_view rest = text;
  int axis = 0;
  for (;; ++axis) {
    const auto cross = rest.find('x');
    const auto voxels = number_in<std::int32_t>(rest.substr(0, cross), text);
    if (voxels < 1 || voxels > largest_division)
      fail(text, fmt::format("isn't between 1 and {} an axis", largest_division));
    if (axis > 2) fail(text, "has more than three axes");
    division.set(axis, voxels);
    if (cross == std::string_view::npos) break;
    rest.remove_prefix(cross + 1);
  }
  if (axis == 0) return {division.x, division.x, division.x};
  if (axis == 1) fail(text, "has two axes");
  return division;
}

} // namespace

DivisionRule parse_division(std::string_view text) {
  using Kind = DivisionRule::Kind;
  DivisionRule rule;
  rule.text = text;
  if (text == "auto") return rule;
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) {
    rule.kind = Kind::fixed;
    rule.fixed = fixed_division(text);
    return rule;
  }
  constexpr std::array<std::pair<std::string_view, Kind>, 4> names{{{"cube-root", Kind::cube_root},
                                                                    {"woo", Kind::woo},
                                                                    {"heterogeneous", Kind::heterogeneous},
                                                                    {"cleary", Kind::cleary}}};
  for (const auto& [name, kind] : names) {
    if (text.substr(0, colon) != name) continue;
    rule.kind = kind;
    rule.parameter = number_in<double>(text.substr(colon + 1), text);
    if (!(rule.parameter > 0 && std::isfinite(rule.parameter))) fail(text, "needs a positive number");
    return rule;
  }
  fail(text, "isn't a rule");
}

namespace {

SurfaceSums measured(const Triangle<double>& triangle, const Boxd& box) {
  const Vec3d normal = cross(triangle.b - triangle.a, triangle.c - triangle.a) * 0.5;
  return {1, box.max - box.min, {std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}};
}

SurfaceSums measured(const Sphere<double>& sphere, const Boxd& box) {
  const double discs = 2 * std::numbers::pi * sphere.radius * sphere.radius;
  return {1, box.max - box.min, {discs, discs, discs}};
}

// The side's projections depend on how the cone lies; half its area along each axis is the mean over all
// directions.
SurfaceSums measured(const Cone<double>& cone, const Boxd& box) {
  const double r0 = std::abs(cone.base_radius), r1 = std::abs(cone.apex_radius);
  // Not std::hypot, whose last bit differs between C libraries.
  const double slant = length(Vec3d{length(cone.apex - cone.base), r1 - r0, 0});
  const double half = std::numbers::pi * (r0 + r1) * slant / 2;
  return {1, box.max - box.min, {half, half, half}};
}

SurfaceSums sum(const SurfaceSums& a, const SurfaceSums& b) {
  return {a.primitives + b.primitives, a.extents + b.extents, a.projections + b.projections};
}

Vec3d center_of(const Boxd& box) {
  return (box.min + box.max) * 0.5;
}

// fold(result, primitive, its box) over all primitives that have a surface, in pieces of fixed size joined in
// order: the same bits for any number of threads.
template <class Stored, class Result, class Fold, class Join>
Result over_primitives(const SceneView<Stored>& scene, const Result& none, const Fold& fold,
                       const Join& join) {
  const auto over = [&](const auto* records, std::uint32_t count) {
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::uint32_t>(0, count, 16384), none,
        [&](const tbb::blocked_range<std::uint32_t>& range, Result result) {
          for (std::uint32_t i = range.begin(); i != range.end(); ++i) {
            const auto primitive = widened(records[i]);
            if (has_surface(primitive)) fold(result, primitive, bounds(primitive));
          }
          return result;
        },
        join);
  };
  return join(join(over(scene.triangles, scene.triangle_count), over(scene.spheres, scene.sphere_count)),
              over(scene.cones, scene.cone_count));
}

// How many primitives are centred where along each axis of a box.
constexpr std::size_t bins = 256;
using CentreHistogram = std::array<std::array<std::uint32_t, bins>, 3>;

// The box between the 5th and the 95th percentile of the centres along each axis, on the histogram's bins.
template <class Stored>
Boxd dense_bounds(const SceneView<Stored>& scene) {
  const Boxd box = cast<double>(scene.clip);
  const Vec3d extent = box.max - box.min;
  const CentreHistogram histogram = over_primitives(
      scene, CentreHistogram{},
      [&](CentreHistogram& h, const auto&, const Boxd& around) {
        const Vec3d center = center_of(around);
        for (int axis = 0; axis < 3; ++axis) {
          const double bin = (center[axis] - box.min[axis]) / extent[axis] * bins;
          ++h[static_cast<std::size_t>(axis)]
             [bin > 0 ? static_cast<std::size_t>(std::min(bin, bins - 1.0)) : 0];
        }
      },
      [](CentreHistogram a, const CentreHistogram& b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (std::size_t i = 0; i < bins; ++i)
            a[axis][i] += b[axis][i];
        }
        return a;
      });
  const std::uint64_t out = std::accumulate(histogram[0].begin(), histogram[0].end(), std::uint64_t{0}) / 20;
  Boxd dense_box = box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& counts = histogram[static_cast<std::size_t>(axis)];
    std::size_t first = 0, last = bins;
    for (std::uint64_t seen = counts[0]; first + 1 < bins && seen <= out; seen += counts[first])
      ++first;
    for (std::uint64_t seen = counts[last - 1]; last > first + 1 && seen <= out; seen += counts[last - 1])
      --last;
    const double bin = extent[axis] / bins;
    dense_box.min.set(axis, box.min[axis] + static_cast<double>(first) * bin);
    dense_box.max.set(axis, box.min[axis] + static_cast<double>(last) * bin);
  }
  return dense_box;
}

} // namespace

template <class Stored>
DivisionStatistics division_statistics(const SceneView<Stored>& scene) {
  const Boxd dense_box = dense_bounds(scene);
  DivisionStatistics result = over_primitives(
      scene, DivisionStatistics{{}, {}, dense_box, 0},
      [&](DivisionStatistics& statistics, const auto& primitive, const Boxd& box) {
        const SurfaceSums own = measured(primitive, box);
        statistics.all = sum(statistics.all, own);
        if (contains(dense_box, center_of(box))) statistics.dense = sum(statistics.dense, own);
      },
      [](const DivisionStatistics& a, const DivisionStatistics& b) {
        return DivisionStatistics{sum(a.all, b.all), sum(a.dense, b.dense), a.dense_box, 0};
      });
  if (scene.primitive_count() > 0)
    result.cone_share = static_cast<double>(scene.cone_count) / scene.primitive_count();
  return result;
}
template DivisionStatistics division_statistics(const SceneView<float>&);
template DivisionStatistics division_statistics(const SceneView<double>&);

double expected_references(const SurfaceSums& sums, const GridLayout& layout) {
  const Vec3d h = voxel_size(layout), e = sums.extents, p = sums.projections;
  // Along an axis of one voxel nothing can be met twice.
  const auto over = [&](double total, int axis) { return layout.division[axis] > 1 ? total / h[axis] : 0.0; };
  const auto face = [&](double total, int u, int v) {
    return layout.division[u] > 1 && layout.division[v] > 1 ? total / (h[u] * h[v]) : 0.0;
  };
  const Vec3d g{1 + over(2 * layout.margin, 0), 1 + over(2 * layout.margin, 1),
                1 + over(2 * layout.margin, 2)}; // a voxel's sides with the margin, in voxels
  const auto primitives = static_cast<double>(sums.primitives);
  const double references = primitives * g.x * g.y * g.z + over(e.x, 0) * g.y * g.z +
                            over(e.y, 1) * g.z * g.x + over(e.z, 2) * g.x * g.y + face(p.x, 1, 2) * g.x +
                            face(p.y, 2, 0) * g.y + face(p.z, 0, 1) * g.z;
  return std::min(references, primitives * static_cast<double>(voxel_count(layout.division)));
}

constexpr double always_references = 0x1p16;
double most_references(std::uint64_t primitives) {
  return always_references + 128 * static_cast<double>(primitives);
}
double most_nested_references(std::uint64_t primitives) {
  return always_references + 16 * static_cast<double>(primitives);
}

namespace {

// Voxels of side 1/per_unit, at least one an axis.
Vec3i division_of(const Vec3d& extent, const Vec3d& per_unit) {
  Vec3i division{};
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::max(1.0, std::round(extent[axis] * per_unit[axis]));
    if (!(voxels <= largest_division)) {
      throw Error(ErrorCode::usage, "division",
                  fmt::format("asks for {:g} voxels along an axis, {} are possible: choose a smaller number",
                              voxels, largest_division));
    }
    division.set(axis, static_cast<std::int32_t>(voxels));
  }
  return division;
}

// What a random line through the dense box costs, in steps from voxel to voxel. It meets a voxel with the
// probability of the voxel's surface over the box's (Crofton).
double expected_cost(const DivisionStatistics& statistics, const GridLayout& layout) {
  const double steps = expected_voxels(layout.division, layout.space.max - layout.space.min);
  // The dense box is at least a voxel thick.
  Vec3d dense_box = statistics.dense_box.max - statistics.dense_box.min;
  const Vec3d h = voxel_size(layout);
  for (int axis = 0; axis < 3; ++axis)
    dense_box.set(axis, std::max(dense_box[axis], h[axis]));
  const double tests = expected_references(statistics.dense, layout) * half_area(h) / half_area(dense_box);
  return division_costs.step * steps + division_costs.test * tests;
}

// Voxels of equal sides, lambda·N of them. A space with a thin side keeps one voxel there, and the other
// sides share what that leaves: so λ means the same for flat scenes.
Vec3d equal_sides(const Vec3d& extent, double voxels) {
  double density = std::cbrt(voxels / (extent.x * extent.y * extent.z));
  for (int round = 0; round < 2; ++round) {
    double volume = 1;
    int thick = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (extent[axis] * density < 1) continue;
      volume *= extent[axis];
      ++thick;
    }
    if (thick > 0) density = std::pow(voxels / volume, 1.0 / thick);
  }
  return {density, density, density};
}

// A quarter of what a merged grid's map may be (merge.h): the rest is for what they are divided into.
constexpr double max_nested = 0x1p26;

// Voxels a primitive: few, but more of them the smaller the dense box's part of the space is; and many for
// cones, whose tests are long: finer voxels save near misses, and lists that a long cone would otherwise be
// in.
double nested_density(const DivisionStatistics& statistics, const Boxd& space) {
  constexpr double least = 0.05, most = 1, of_cones = 32;
  const auto volume = [](const Boxd& box) {
    const Vec3d w = box.max - box.min;
    return w.x * w.y * w.z;
  };
  const double usual =
      std::clamp(least * std::sqrt(volume(space) / volume(statistics.dense_box)), least, most);
  return std::max(usual, of_cones * statistics.cone_share);
}

Vec3i automatic_division(const DivisionStatistics& statistics, const Boxd& space, double margin) {
  constexpr double tolerance = 1.05;
  constexpr int steps_an_octave = 3, max_octaves = 27; // up to 2^27 voxels
  const Vec3d extent = space.max - space.min;
  const double most = most_references(statistics.all.primitives);
  std::vector<std::pair<double, Vec3i>> candidates;
  double best = std::numeric_limits<double>::max();
  std::size_t allowed = 0; // of the candidates
  for (int step = 0; step <= steps_an_octave * max_octaves; ++step) {
    const Vec3d per_unit = equal_sides(extent, std::exp2(static_cast<double>(step) / steps_an_octave));
    if (!(largest_magnitude(extent * per_unit) <= largest_division / 2.0)) break;
    const Vec3i division = division_of(extent, per_unit);
    const GridLayout layout{space, division, margin};
    const double references = expected_references(statistics.all, layout);
    // The best may be finer than what is allowed: then the finest that is allowed comes closest to it.
    if (references > most + 0x1p24) break;
    const double cost = expected_cost(statistics, layout);
    candidates.emplace_back(cost, division);
    best = std::min(best, cost);
    if (references <= most) allowed = candidates.size();
  }
  for (std::size_t i = 0; i < allowed; ++i) {
    if (candidates[i].first <= best * tolerance) return candidates[i].second;
  }
  return allowed > 0 ? candidates[allowed - 1].second : Vec3i{1, 1, 1};
}

Vec3i nested_division(const DivisionStatistics& statistics, const Boxd& space, double margin) {
  const Vec3d extent = space.max - space.min;
  const double count = static_cast<double>(std::max<std::uint64_t>(statistics.all.primitives, 1));
  double voxels = std::clamp(nested_density(statistics, space) * count, 1.0, max_nested);
  for (;; voxels /= 2) {
    const Vec3d per_unit = equal_sides(extent, voxels);
    const bool fits = largest_magnitude(extent * per_unit) <= largest_division;
    if (!fits && voxels > 1) continue;
    const Vec3i division = fits ? division_of(extent, per_unit) : Vec3i{1, 1, 1};
    if (voxels <= 1 || expected_references(statistics.all, {space, division, margin}) <=
                           most_nested_references(statistics.all.primitives))
      return division;
  }
}

} // namespace

Vec3i choose_division(const DivisionRule& rule, const DivisionStatistics& statistics, const Boxd& space,
                      double margin) {
  const Vec3d extent = space.max - space.min;
  const double count = static_cast<double>(std::max<std::uint64_t>(statistics.all.primitives, 1));
  const double longest = std::max(extent.x, std::max(extent.y, extent.z));
  const double along = rule.parameter * std::cbrt(count);
  const auto same = [](double value) { return Vec3d{value, value, value}; };
  switch (rule.kind) {
  case DivisionRule::Kind::fixed:
    return rule.fixed;
  case DivisionRule::Kind::cube_root:
    return division_of(same(1), same(along));
  case DivisionRule::Kind::woo:
    return division_of(extent, same(along / longest));
  case DivisionRule::Kind::heterogeneous:
    return division_of(extent, same(along / std::cbrt(extent.x * extent.y * extent.z)));
  case DivisionRule::Kind::cleary:
    return division_of(extent, equal_sides(extent, std::max(1.0, rule.parameter * count)));
  case DivisionRule::Kind::automatic:
    return automatic_division(statistics, space, margin);
  case DivisionRule::Kind::nested:
    return nested_division(statistics, space, margin);
  }
  return {1, 1, 1};
}

} // namespace masu
