#include "libgrid/statistics.h"

#include "libgrid/build.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace masu {
namespace {

void describe(GridStatistics& statistics) {
  const std::vector<std::uint64_t>& histogram = statistics.histogram;
  const auto cells = static_cast<double>(statistics.occupied_cells);
  if (statistics.occupied_cells == 0) return;
  statistics.mean = static_cast<double>(statistics.references) / cells;
  double squares = 0;
  for (std::size_t n = 0; n < histogram.size(); ++n) {
    const double off = static_cast<double>(n) - statistics.mean;
    squares += off * off * static_cast<double>(histogram[n]);
  }
  statistics.stddev = std::sqrt(squares / cells);
  // The rank-th smallest, from 0.
  const auto at_rank = [&](std::uint64_t rank) {
    std::uint64_t seen = 0;
    std::size_t n = 0;
    while (n + 1 < histogram.size() && (seen += histogram[n]) <= rank)
      ++n;
    return static_cast<std::uint64_t>(n);
  };
  const std::uint64_t last = statistics.occupied_cells - 1;
  statistics.median = static_cast<double>(at_rank(last / 2) + at_rank((last + 1) / 2)) / 2;
  statistics.p99 = at_rank(static_cast<std::uint64_t>(std::ceil(0.99 * cells)) - 1);
  statistics.min = at_rank(0);
  statistics.max = histogram.size() - 1;
}

} // namespace

template <class Real>
GridStatistics grid_statistics(const GridView<Real>& grid, std::span<const std::uint32_t> cells) {
  GridStatistics statistics;
  statistics.voxels = voxel_count(grid.division);
  statistics.occupied_cells = cells.size() - 1;
  statistics.occupied_voxels = statistics.occupied_cells;
  statistics.cells = statistics.voxels;
  statistics.references = cells.back();
  for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell) {
    const std::uint32_t count = cells[cell + 1] - cells[cell];
    if (count >= statistics.histogram.size()) statistics.histogram.resize(count + std::size_t{1}, 0);
    ++statistics.histogram[count];
  }
  describe(statistics);
  return statistics;
}
template GridStatistics grid_statistics(const GridView<float>&, std::span<const std::uint32_t>);
template GridStatistics grid_statistics(const GridView<double>&, std::span<const std::uint32_t>);

template <class Real>
std::uint32_t references_in(const GridView<Real>& grid, const Vec3i& voxel) {
  const std::uint32_t word = look_up(grid, voxel).word;
  if ((word & occupied_bit) == 0) return 0;
  const std::uint32_t cell = word & ~occupied_bit;
  return grid.cells[cell + 1] - grid.cells[cell];
}
template std::uint32_t references_in(const GridView<float>&, const Vec3i&);
template std::uint32_t references_in(const GridView<double>&, const Vec3i&);

template <class Stored>
std::uint64_t occupied_voxels(const SceneView<Stored>& scene, const Lattice& lattice, Overlap overlap) {
  return build_uniform(scene, lattice, overlap).cells.size() - 1;
}
template std::uint64_t occupied_voxels(const SceneView<float>&, const Lattice&, Overlap);
template std::uint64_t occupied_voxels(const SceneView<double>&, const Lattice&, Overlap);

template <class Stored>
std::uint64_t occupied_half_open(const SceneView<Stored>& scene, const Lattice& lattice) {
  const Vec3d size = voxel_size(lattice);
  std::vector<bool> occupied(voxel_count(lattice.division), false);
  const auto mark = [&](const Boxd& box) {
    VoxelRange range{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto voxel = [&](double at) {
        const double number = std::floor((at - lattice.space.min[axis]) / size[axis]);
        return static_cast<std::int32_t>(std::clamp(number, 0.0, lattice.division[axis] - 1.0));
      };
      range.first.set(axis, voxel(box.min[axis]));
      range.last.set(axis, voxel(box.max[axis]));
    }
    for_each_voxel(range,
                   [&](const Vec3i& voxel) { occupied[linear_index(voxel, lattice.division)] = true; });
  };
  for (std::uint32_t i = 0; i < scene.triangle_count; ++i)
    mark(bounds(widened(scene.triangles[i])));
  for (std::uint32_t i = 0; i < scene.sphere_count; ++i)
    mark(bounds(widened(scene.spheres[i])));
  for (std::uint32_t i = 0; i < scene.cone_count; ++i)
    mark(box_for_overlap(widened(scene.cones[i])));
  return static_cast<std::uint64_t>(std::count(occupied.begin(), occupied.end(), true));
}
template std::uint64_t occupied_half_open(const SceneView<float>&, const Lattice&);
template std::uint64_t occupied_half_open(const SceneView<double>&, const Lattice&);

} // namespace masu
