#include "libgrid/build/chosen_structure.h"

#include "libgrid/build/hierarchy.h"
#include "libgrid/build/sampled_costs.h"
#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace masu {
namespace {

// About how many bytes building takes at its peak, for so many references.
double expected_build_bytes(const GridLayout& layout, double references) {
  // Pairs as they are emitted, and sorted; a block's map for each few cells.
  constexpr double pair_bytes = 8 + sizeof(std::uint64_t) + sizeof(PrimitiveIndex);
  const std::int32_t block_log2 = block_log2_for(layout.division);
  const double words = static_cast<double>(voxel_count(blocks_of(layout.division, block_log2)));
  const double block_maps = block_log2 == 0 ? 0 : references / 16 * 512 * 4;
  return 4 * words + block_maps + references * pair_bytes;
}

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
    return merge_rule_of(options.quality);
  case GridKind::uniform:
  case GridKind::automatic:
  case GridKind::fastest:
    break;
  }
  return "";
}

GridOptions of_kind(GridKind kind, GridOptions options) {
  options.kind = kind;
  return options;
}

struct Candidate {
  GridKind kind;
  GridLayout layout;
};

// A layout's division times a factor along each axis.
GridLayout scaled(GridLayout layout, double factor) {
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::clamp<double>(std::round(layout.division[axis] * factor), 1, largest_division);
    layout.division.set(axis, static_cast<std::int32_t>(voxels));
  }
  return layout;
}

// At least one; more than one where the choice is automatic.
template <class Stored>
std::vector<Candidate> candidates_for(const SceneView<Stored>& scene, const Boxd& bounds,
                                      const BuildOptions& options) {
  const DivisionStatistics statistics = division_statistics(scene);
  const bool automatic_division = options.division.kind == DivisionRule::Kind::automatic;
  const GridKind kind = options.grid.kind;
  std::vector<Candidate> candidates;
  const auto layout_by = [&](const DivisionRule& rule) {
    return make_grid_layout<Stored>(bounds, options.space, rule, statistics);
  };
  const auto add = [&](GridKind of, const GridLayout& layout) {
    for (const Candidate& known : candidates)
      if (known.kind == of && known.layout.division == layout.division) return;
    check_memory(layout, expected_references(statistics.all, layout), automatic_division);
    candidates.push_back({of, layout});
  };
  const auto add_uniform = [&](std::initializer_list<double> factors) {
    const GridLayout usual = layout_by(options.division);
    for (const double factor : factors) {
      const GridLayout layout = scaled(usual, factor);
      if (factor <= 1 || expected_references(statistics.all, layout) <= most_references(statistics))
        add(GridKind::uniform, layout);
    }
  };
  const auto add_irregular = [&] { // whose voxels start out coarser, unless their division was given
    DivisionRule rule = options.division;
    if (automatic_division) rule.kind = DivisionRule::Kind::nested;
    const GridLayout usual = layout_by(rule);
    add(GridKind::irregular, usual);
    if (automatic_division) add(GridKind::irregular, scaled(usual, 0.25));
  };
  const auto add_hierarchy = [&] { // whose space isn't divided
    DivisionRule rule;
    rule.kind = DivisionRule::Kind::fixed;
    add(GridKind::hierarchy, layout_by(rule));
  };
  if (kind == GridKind::hierarchy) {
    add_hierarchy();
  } else if (kind == GridKind::irregular) {
    add_irregular();
  } else if (kind == GridKind::fastest || (kind == GridKind::automatic && automatic_division)) {
    add_uniform({1});
    add_irregular();
    // By the geometry alone, not by the memory that is free: the same scene gives the same bytes.
    if (kind == GridKind::fastest && fits_hierarchy(candidates.front().layout.space) &&
        scene.primitive_count() <= max_hierarchy_primitives)
      add_hierarchy();
  } else if (kind == GridKind::uniform && automatic_division) {
    add_uniform({1, 0.625, 1.6});
  } else {
    // Whoever gives a division means those voxels, not ones to divide further.
    add(kind == GridKind::automatic ? GridKind::uniform : kind, layout_by(options.division));
  }
  return candidates;
}

template <class Stored>
Grid fastest_of(const std::vector<Candidate>& candidates, GridBuilder<Stored>& builder,
                const BuildOptions& options, std::vector<Considered>& considered) {
  const auto one = [&](const Candidate& candidate) {
    return builder.build(candidate.layout, options.overlap, of_kind(candidate.kind, options.grid));
  };
  if (candidates.size() == 1 || builder.scene().primitive_count() == 0) return one(candidates.front());
  // What comes first is the usual one. Pictures take up to 7 % longer through a coarser top division that
  // lists take as long through: their threads share no tests.
  constexpr double clearly = 0.95;
  Grid fastest;
  double least = std::numeric_limits<double>::infinity();
  std::size_t tried = 0;
  for (const Candidate& candidate : candidates) {
    builder.progress().begin_part(tried++, candidates.size());
    Grid built = builder.try_build(candidate.layout, options.overlap, of_kind(candidate.kind, options.grid));
    if (built.exceeded != nullptr) continue;
    const SampledCosts costs = sampled_costs(builder.scene(), built, &builder.progress());
    const double time = expected_time(costs, candidate.kind, options.processor);
    considered.push_back({candidate.kind, candidate.layout.division, costs, time});
    if (!(time < clearly * least)) continue;
    least = time;
    fastest = std::move(built);
  }
  return least < std::numeric_limits<double>::infinity() ? std::move(fastest) : one(candidates.front());
}

} // namespace

GridKind kind_of(StructureChoice structure, GridKind merge, const DivisionRule& division,
                 HierarchyQuality quality) {
  const bool is_merge_given = merge != GridKind::automatic;
  if (structure == StructureChoice::hierarchy) {
    if (is_merge_given) throw Error(ErrorCode::usage, "merge", "is of grids alone");
    return GridKind::hierarchy;
  }
  if (structure == StructureChoice::fastest && !is_merge_given &&
      division.kind == DivisionRule::Kind::automatic)
    return GridKind::fastest;
  if (quality != HierarchyQuality::high) throw Error(ErrorCode::usage, "quality", "is of hierarchies alone");
  return merge;
}

template <class Stored>
DescribedGrid build_chosen(GridBuilder<Stored>& builder, const SceneGeometry& geometry,
                           const BuildOptions& options) {
  const std::vector<Candidate> candidates = candidates_for(builder.scene(), geometry.bounds, options);
  DescribedGrid result;
  result.grid = fastest_of(candidates, builder, options, result.considered);
  result.provenance = {geometry.hash,
                       builder.scene().primitive_count(),
                       geometry.origin,
                       options.space,
                       options.overlap,
                       options.division.text,
                       merge_text(result.grid, options.grid)};
  return result;
}
template DescribedGrid build_chosen(GridBuilder<float>&, const SceneGeometry&, const BuildOptions&);
template DescribedGrid build_chosen(GridBuilder<double>&, const SceneGeometry&, const BuildOptions&);

} // namespace masu
