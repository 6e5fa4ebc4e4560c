#include "libgrid/build/choose.h"

#include "libgrid/file/grid_file.h"
#include "libgrid/map_statistics.h"
#include "libscene/error.h"

namespace masu {
namespace {

double cost_of(const ExpectedRay& ray, const MergeRule& rule) {
  return rule.step_over_test * ray.cells + ray.tests;
}
double expected_cost_of_uniform(const Grid& grid, const MergeRule& rule) {
  return cost_of(map_statistics(view_of<double>(grid), grid.references).ray, rule);
}
double expected_cost_of_irregular(const Grid& grid, const MergeRule& rule) {
  const MergedGridView<double> view = merged_view_of<double>(grid);
  return cost_of(expected_ray(view, grid.cells, own_voxels_of_rows(view, grid.cells)), rule);
}

std::size_t bytes_of(const Grid& grid) {
  return grid.voxel_map.size() * sizeof(std::uint32_t) + grid.cells.size() * sizeof(MergedCell) +
         grid.references.size() * sizeof(PrimitiveIndex);
}

} // namespace

template <class Stored>
Grid build_chosen(GridBuilder<Stored>& builder, const GridLayout& uniform, const GridLayout& nested,
                  Overlap overlap, const MergeRule& rule) {
  constexpr double tie = 0.9;
  MergeRule irregular = rule;
  irregular.merge = Merge::irregular;
  Grid plain = builder.uniform(uniform, overlap), merged;
  try {
    merged = builder.merged(nested, overlap, irregular);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::usage) throw;
    return plain; // how large a merged map becomes shows only when it is made
  }
  const double plain_cost = expected_cost_of_uniform(plain, rule),
               merged_cost = expected_cost_of_irregular(merged, rule);
  const bool clear = std::min(plain_cost, merged_cost) < tie * std::max(plain_cost, merged_cost);
  const bool take_plain = clear ? plain_cost < merged_cost : bytes_of(plain) <= bytes_of(merged);
  return take_plain ? std::move(plain) : std::move(merged);
}
template Grid build_chosen(GridBuilder<float>&, const GridLayout&, const GridLayout&, Overlap,
                           const MergeRule&);
template Grid build_chosen(GridBuilder<double>&, const GridLayout&, const GridLayout&, Overlap,
                           const MergeRule&);

} // namespace masu
