#include "libgrid/build/build_grid.h"

#include "libgrid/build/hierarchy.h"
#include "libgrid/build/sampled_costs.h"
#include "libgrid/statistics/map_statistics.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"

#include <fmt/format.h>

#include <utility>

namespace masu {
namespace {

// Throws Error(usage, "division", …).
void check_memory(const GridLayout& layout, double references, bool is_automatic) {
  const double needed = expected_build_bytes(layout, references), available = available_memory();
  if (needed <= available) return;
  const Vec3i n = layout.division;
  throw Error(
      ErrorCode::usage, "division",
      fmt::format("{}{}x{}x{} voxels need about {:.1f} GB to build, {:.1f} GB are free: choose a coarser one",
                  is_automatic ? "auto is too fine for this machine: " : "", n.x, n.y, n.z, needed / 1e9,
                  available / 1e9));
}

// As files have it.
std::string merge_text(const Grid& grid, const GridOptions& options) {
  switch (grid.kind) {
  case GridKind::x:
    return "x";
  case GridKind::balance:
    return fmt::format("balance target {}", options.target);
  case GridKind::irregular:
    return fmt::format("irregular nested {} detail {} step {} alpha {} expand {}", options.nested_log2,
                       grid.detail, options.step_cost, options.alpha, options.expansions);
  case GridKind::hierarchy:
    return "bvh";
  case GridKind::uniform:
  case GridKind::automatic:
  case GridKind::fastest:
    break;
  }
  return "";
}

double cost_of(const ExpectedRay& ray, const GridOptions& options) {
  return options.step_cost * ray.cells + ray.tests;
}
double expected_cost_of_uniform(const Grid& grid, const GridOptions& options) {
  return cost_of(map_statistics(view_of<double>(grid), grid.references).ray, options);
}
double expected_cost_of_irregular(const Grid& grid, const GridOptions& options) {
  const MergedGridView<double> view = merged_view_of<double>(grid);
  return cost_of(expected_ray(view, grid.cells, own_voxels_of_rows(view, grid.cells)), options);
}

std::size_t bytes_of(const Grid& grid) {
  return grid.voxel_map.size() * sizeof(std::uint32_t) + grid.cells.size() * sizeof(MergedCell) +
         grid.references.size() * sizeof(PrimitiveIndex);
}

GridOptions of_kind(GridKind kind, GridOptions options) {
  options.kind = kind;
  return options;
}

template <class Stored>
Grid build_automatic(GridBuilder<Stored>& builder, const GridLayout& uniform_layout, const GridLayout& nested,
                     Overlap overlap, const GridOptions& options) {
  constexpr double tie = 0.9;
  Grid uniform = builder.build(uniform_layout, overlap, of_kind(GridKind::uniform, options));
  BuildResult irregular = builder.try_build(nested, overlap, of_kind(GridKind::irregular, options));
  if (irregular.exceeded != nullptr) return uniform;
  const double uniform_cost = expected_cost_of_uniform(uniform, options),
               irregular_cost = expected_cost_of_irregular(irregular.grid, options);
  const bool clear = std::min(uniform_cost, irregular_cost) < tie * std::max(uniform_cost, irregular_cost);
  const bool take_uniform =
      clear ? uniform_cost < irregular_cost : bytes_of(uniform) <= bytes_of(irregular.grid);
  return take_uniform ? std::move(uniform) : std::move(irregular.grid);
}

template <class Stored>
Grid build_fastest(GridBuilder<Stored>& builder, const GridLayout& nested, const GridLayout& one_voxel,
                   Overlap overlap, const GridOptions& options) {
  const SceneView<Stored>& scene = builder.scene();
  BuildResult irregular = builder.try_build(nested, overlap, of_kind(GridKind::irregular, options));
  const bool has_grid = irregular.exceeded == nullptr;
  // By the geometry alone, not by the memory that is free: the same scene gives the same bytes.
  const bool fits = fits_hierarchy(one_voxel.space) && scene.primitive_count() <= max_hierarchy_primitives;
  if (has_grid && (scene.primitive_count() == 0 || !fits)) return std::move(irregular.grid);
  Grid hierarchy = builder.build(one_voxel, overlap, of_kind(GridKind::hierarchy, options));
  if (!has_grid) return hierarchy;
  const double ratio = expected_ratio(sampled_costs(scene, irregular.grid), sampled_costs(scene, hierarchy));
  return ratio > 1 ? std::move(hierarchy) : std::move(irregular.grid);
}

} // namespace

template <class Stored>
DescribedGrid build_grid(GridBuilder<Stored>& builder, const SceneGeometry& geometry,
                         const BuildOptions& options) {
  const DivisionStatistics statistics = division_statistics(builder.scene());
  const bool automatic_division = options.division.kind == DivisionRule::Kind::automatic;
  // Voxels that are divided further start out coarser, unless their division was given.
  const auto layout_for = [&](GridKind kind) {
    DivisionRule rule = options.division;
    if (kind == GridKind::irregular && automatic_division) rule.kind = DivisionRule::Kind::nested;
    if (kind == GridKind::hierarchy) { // whose space isn't divided
      rule.kind = DivisionRule::Kind::fixed;
      rule.fixed = {1, 1, 1};
    }
    const GridLayout layout = make_grid_layout<Stored>(geometry.bounds, options.space, rule, statistics);
    check_memory(layout, expected_references(statistics.all, layout), automatic_division);
    return layout;
  };
  const auto built = [&] {
    // Whoever gives a division means those voxels, not ones to divide further.
    const bool automatic = options.grid.kind == GridKind::automatic;
    if (automatic && automatic_division)
      return build_automatic(builder, layout_for(GridKind::uniform), layout_for(GridKind::irregular),
                             options.overlap, options.grid);
    if (options.grid.kind == GridKind::fastest)
      return build_fastest(builder, layout_for(GridKind::irregular), layout_for(GridKind::hierarchy),
                           options.overlap, options.grid);
    const GridKind kind = automatic ? GridKind::uniform : options.grid.kind;
    return builder.build(layout_for(kind), options.overlap, of_kind(kind, options.grid));
  };
  DescribedGrid result{built(), {}};
  result.provenance = {geometry.hash,
                       builder.scene().primitive_count(),
                       geometry.origin,
                       options.space,
                       options.overlap,
                       options.division.text,
                       merge_text(result.grid, options.grid)};
  return result;
}
template DescribedGrid build_grid(GridBuilder<float>&, const SceneGeometry&, const BuildOptions&);
template DescribedGrid build_grid(GridBuilder<double>&, const SceneGeometry&, const BuildOptions&);

} // namespace masu
