#include "libgrid/build/recipe.h"

#include "libgrid/build/choose.h"
#include "libscene/error.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

namespace masu {
namespace {

// What the machine can still give, in bytes; infinity where it doesn't tell.
double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string key, rest; file >> key && std::getline(file, rest);) {
    if (key == "MemAvailable:") return std::stod(rest) * 1024;
  }
  return HUGE_VAL;
}

void check_memory(const GridLayout& layout, double references) {
  const double needed = expected_build_bytes(layout, references), available = available_memory();
  if (needed <= available) return;
  const Vec3i n = layout.division;
  throw Error(
      ErrorCode::usage, "--division",
      fmt::format("{}x{}x{} voxels need about {:.1f} GB to build, {:.1f} GB are free: choose a coarser one",
                  n.x, n.y, n.z, needed / 1e9, available / 1e9));
}

std::string merge_text(Merge merge, const MergeRule& rule) {
  switch (merge) {
  case Merge::none:
    return "";
  case Merge::x:
    return "x";
  case Merge::balance:
    return fmt::format("balance target {}", rule.target);
  case Merge::irregular:
    return fmt::format("irregular nested {} detail {} step {} alpha {} stretch {}", rule.nested_log2,
                       rule.detail, rule.step_over_test, rule.alpha, rule.expansions);
  }
  return "";
}

// A division that is to be divided further starts out coarser, where it is ours to choose.
DivisionRule nested_rule(DivisionRule rule) {
  if (rule.kind == DivisionRule::Kind::automatic) rule.kind = DivisionRule::Kind::nested;
  return rule;
}

} // namespace

template <class Stored>
Grid build_grid(GridBuilder<Stored>& builder, const Boxd& bounds, const BuildOptions& recipe) {
  const DivisionRule& rule = recipe.division;
  const DivisionStatistics statistics = division_statistics(builder.scene());
  const auto lattice_by = [&](const DivisionRule& by) {
    const GridLayout layout = make_grid_layout<Stored>(bounds, recipe.space, by, statistics);
    check_memory(layout, expected_references(statistics.all, layout));
    return layout;
  };
  MergeRule merge = recipe.merge;
  switch (recipe.choice) {
  case MergeChoice::automatic:
    // Who says how many voxels there are to be means those, not ones to divide further.
    if (rule.kind != DivisionRule::Kind::automatic) return builder.uniform(lattice_by(rule), recipe.overlap);
    return build_chosen(builder, lattice_by(rule), lattice_by(nested_rule(rule)), recipe.overlap, merge);
  case MergeChoice::none:
    return builder.uniform(lattice_by(rule), recipe.overlap);
  case MergeChoice::x:
    merge.merge = Merge::x;
    return builder.merged(lattice_by(rule), recipe.overlap, merge);
  case MergeChoice::balance:
    merge.merge = Merge::balance;
    return builder.merged(lattice_by(rule), recipe.overlap, merge);
  case MergeChoice::irregular:
    merge.merge = Merge::irregular;
    return builder.merged(lattice_by(nested_rule(rule)), recipe.overlap, merge);
  }
  return {};
}
template Grid build_grid(GridBuilder<float>&, const Boxd&, const BuildOptions&);
template Grid build_grid(GridBuilder<double>&, const Boxd&, const BuildOptions&);

GridOrigin origin_of(const Grid& grid, const BuildOptions& recipe, const Hash& scene_hash,
                     std::uint64_t primitives) {
  return {scene_hash,     primitives,           recipe.space,
          recipe.overlap, recipe.division.text, merge_text(grid.merge, recipe.merge)};
}

} // namespace masu
