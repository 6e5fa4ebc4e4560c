// What a grid lists against what each primitive says of each voxel, and the numbers told of it; the same
// bytes for any number of threads. Statistics of where cells are, against every voxel looked up by itself,
// and against random lines.
#include "libgrid/statistics/statistics.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace masu {
namespace {

template <class Stored>
Lists lists_of(const Structure& grid) {
  const GridView<Stored> view = view_of<Stored>(grid);
  Lists lists;
  for_each_voxel_of({{0, 0, 0}, grid.layout.division}, [&](const Vec3i& voxel) {
    const MapEntry entry = look_up(view, voxel);
    if ((entry.word & occupied_bit) == 0) return;
    lists[linear_index(voxel, grid.layout.division)] =
        primitives_of(grid.references, entry.word & ~occupied_bit);
  });
  return lists;
}

template <class Stored>
class Built : public RandomTest {
protected:
  // Returns the grid.
  static Structure expect_lists(TestScene<Stored>& scene, const Vec3i& division,
                                Overlap overlap = Overlap::exact) {
    const auto layout = layout_in<Stored>(scene.bounds(), division);
    Structure grid = build_structure(scene.view(), layout, overlap);
    EXPECT_EQ(lists_of<Stored>(grid), lists_of(scene, layout, overlap));
    return grid;
  }
};
TYPED_TEST_SUITE(Built, Reals);

TYPED_TEST(Built, EveryVoxelListsItsPrimitivesInRisingOrder) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(60); i > 0; --i) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 60);
    ASSERT_EQ(this->expect_lists(scene, random_division(chance, 24), any_overlap(chance)).block_log2, 0);
  }
}

// More primitives than one piece holds, and crowded and lonely buckets side by side.
TYPED_TEST(Built, ManyPrimitivesAreListedLikeFew) {
  TestScene<TypeParam> scene;
  add_triangles(scene, this->chance_, 20'000, 0.002, 0.01);
  this->expect_lists(scene, {70, 50, 60});
}

// Beyond 2²³ voxels the map has two levels; what it leads to is the same.
TYPED_TEST(Built, MapsOfTwoLevelsLeadToTheSameLists) {
  for (const Vec3i& division : {Vec3i{203, 207, 211}, {1, 3000, 3001}, {65535, 131, 1}}) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(this->chance_, 12);
    scene.spheres.clear(); // slow in so many voxels
    scene.cones.clear();
    scene.triangles.push_back(triangle_of<TypeParam>({-1, -1, -1}, {1, 1, 1}, {1, TypeParam(0.9), 1}));
    ASSERT_GT(this->expect_lists(scene, division).block_log2, 0);
  }
}

TYPED_TEST(Built, TheNumberOfThreadsShowsInNoByte) {
  TestScene<TypeParam> scene;
  add_triangles(scene, this->chance_, 30'000, 0.02, 0.1);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d at = this->chance_.in_cube(1);
    scene.spheres.push_back(sphere_of<TypeParam>(at, 0.01));
    scene.cones.push_back(cone_of<TypeParam>(at, 0.01, at + this->chance_.direction() * 0.02, 0.005));
  }
  const SceneView<TypeParam> view = scene.view();
  const std::pair<StructureKind, Vec3i> grids[] = {
      {StructureKind::uniform, {31, 32, 33}}, {StructureKind::uniform, {220, 220, 220}},
      {StructureKind::x, {31, 40, 33}},       {StructureKind::balance, {31, 40, 33}},
      {StructureKind::irregular, {7, 6, 5}},  {StructureKind::hierarchy, {1, 1, 1}}};
  for (const auto& [kind, division] : grids) {
    SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind));
    StructureOptions options{kind};
    const auto layout = layout_in<TypeParam>(scene.bounds(), division);
    compare_threads([&] { return build_structure(view, layout, Overlap::exact, options); }, expect_same);
  }
  compare_threads([&] { return division_statistics(view); },
                  [](const DivisionStatistics& a, const DivisionStatistics& b) {
                    EXPECT_EQ(a.all.extents, b.all.extents);
                    EXPECT_EQ(a.all.projections, b.all.projections);
                    EXPECT_EQ(a.dense.projections, b.dense.projections);
                  });
}

// --- Numbers ---------------------------------------------------------------------------------------------

TYPED_TEST(Built, StatisticsAreWhatCountingVoxelByVoxelGives) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(40); i > 0; --i) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, i % 10 == 0 ? 0 : 60);
    const auto layout = layout_in<TypeParam>(scene.bounds(), random_division(chance, 20));
    const Overlap overlap = any_overlap(chance);
    const Structure grid = build_structure(scene.view(), layout, overlap);
    EXPECT_TRUE(grid.cells.empty());
    const GridView<double> view = view_of<double>(grid);
    const GridStatistics told = grid_statistics(voxel_count(layout.division), grid.references);

    std::vector<std::uint64_t> counts; // of the occupied voxels
    std::uint64_t references = 0;
    for_each_voxel_of({{0, 0, 0}, layout.division}, [&](const Vec3i& voxel) {
      const std::uint32_t count = references_in(view, voxel);
      if (count > 0) counts.push_back(count);
      references += count;
    });
    std::sort(counts.begin(), counts.end());
    EXPECT_EQ(told.occupied_cells, counts.size());
    EXPECT_EQ(told.references, references);
    EXPECT_EQ(occupied_voxels(scene.view(), layout, overlap), counts.size());
    const MapStatistics map = map_statistics(view, std::span(grid.references));
    const Vec3d size = cast<double>(view.voxel_size);
    const double a_voxel = half_area(size) / half_area(cast<double>(layout.division) * size);
    const double voxels = static_cast<double>(voxel_count(layout.division)) * a_voxel;
    EXPECT_EQ(map.voxels, voxel_count(layout.division));
    EXPECT_EQ(map.occupied_voxels, counts.size());
    EXPECT_EQ(map.words, std::vector<std::uint64_t>{map.voxels});
    EXPECT_EQ(map.loads, 1);
    EXPECT_NEAR(map.ray.cells, voxels, 1e-9 * voxels);
    EXPECT_NEAR(map.ray.tests, static_cast<double>(references) * a_voxel, 1e-9 * (1 + map.ray.tests));
    EXPECT_EQ(map.ray.voxels_skipped, 0);
    EXPECT_TRUE(map.cells_by_size.empty());
    if (counts.empty()) {
      EXPECT_TRUE(grid.references.empty());
      EXPECT_TRUE(std::ranges::all_of(grid.voxel_map, [](std::uint32_t word) { return word == 0; }));
      EXPECT_EQ(told.max, 0U);
      EXPECT_EQ(told.mean, 0);
      continue;
    }

    const auto n = static_cast<double>(counts.size());
    const double mean = static_cast<double>(references) / n;
    double squares = 0;
    for (const std::uint64_t count : counts)
      squares += (static_cast<double>(count) - mean) * (static_cast<double>(count) - mean);
    EXPECT_DOUBLE_EQ(told.mean, mean);
    EXPECT_NEAR(told.stddev, std::sqrt(squares / n), 1e-9 * mean);
    EXPECT_EQ(told.min, counts.front());
    EXPECT_EQ(told.max, counts.back());
    const std::size_t middle = counts.size() / 2;
    const double median = counts.size() % 2 == 1
                              ? static_cast<double>(counts[middle])
                              : static_cast<double>(counts[middle - 1] + counts[middle]) / 2;
    EXPECT_EQ(told.median, median);
    // The least number that 99 % of the cells don't pass.
    const auto not_passing = [&](std::uint64_t limit) {
      return static_cast<double>(std::upper_bound(counts.begin(), counts.end(), limit) - counts.begin());
    };
    EXPECT_GE(not_passing(told.p99), 0.99 * n);
    EXPECT_LT(not_passing(told.p99 - 1), 0.99 * n);
    std::vector<std::uint64_t> histogram(counts.back() + 1, 0);
    for (const std::uint64_t count : counts)
      ++histogram[count];
    EXPECT_EQ(told.histogram, histogram);
    if (this->HasFailure()) return;
  }
}

// Voxels without their upper faces: a box that ends on a face isn't in the voxel beyond; one that begins
// there is.
TEST(HalfOpenVoxels, HoldWhatLiesOnTheirLowerFaces) {
  TestScene<double> scene;
  scene.triangles.push_back(triangle_of<double>({0, 0, 0}, {1, 0, 0}, {0, 1, 0})); // to the faces at 1
  const GridLayout layout{{{0, 0, 0}, {4, 4, 4}}, {4, 4, 4}, 0};
  EXPECT_EQ(occupied_half_open(scene.view(), layout), 4U);
  EXPECT_EQ(occupied_voxels(scene.view(), layout, Overlap::box), 4U);
  scene.triangles[0] = triangle_of<double>({1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1});
  EXPECT_EQ(occupied_half_open(scene.view(), layout), 1U);
  EXPECT_EQ(occupied_voxels(scene.view(), layout, Overlap::box), 8U);
  // On the space's upper boundary: in the last voxel, for it must be somewhere.
  scene.triangles[0] = triangle_of<double>({4, 4, 4}, {4, 4, 4}, {4, 4, 4});
  EXPECT_EQ(occupied_half_open(scene.view(), layout), 1U);
}

// --- Where cells are -------------------------------------------------------------------------------------

StructureOptions random_rule(Chance& chance) {
  StructureOptions options{
      chance.one_of({StructureKind::x, StructureKind::balance, StructureKind::irregular})};
  options.target = static_cast<std::uint32_t>(chance.whole(1, 6));
  options.step_cost = chance.uniform(0.1, 4);
  options.nested_log2 = chance.whole(0, 4);
  options.expand = chance.whole(0, 3);
  return options;
}

// Words of the map that a look-up of the voxel loads.
template <class Real>
int loads(const MergedGridView<Real>& grid, const Vec3i& voxel) {
  Vec3i level{grid.nested_log2, grid.nested_log2, grid.nested_log2};
  std::uint32_t word = grid.voxel_map[linear_index(shifted(voxel, grid.nested_log2), grid.top)];
  int count = 1;
  for (; (word & occupied_bit) == 0; ++count) {
    const MapDivision division = map_division(word);
    level = level - division.log2;
    const Vec3i at{voxel.x >> level.x, voxel.y >> level.y, voxel.z >> level.z};
    word = grid.voxel_map[division.offset + index_in_division(at, division.log2)];
  }
  return count;
}

// Whether the line meets the box.
bool meets(const Vec3d& origin, const Vec3d& direction, const Vec3d& low, const Vec3d& high) {
  double from = -HUGE_VAL, to = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - origin[axis]) / direction[axis],
                 b = (high[axis] - origin[axis]) / direction[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from < to;
}

template <class Stored>
class MapStatisticsOf : public RandomTest {};
TYPED_TEST_SUITE(MapStatisticsOf, Reals);

TYPED_TEST(MapStatisticsOf, MergedGridsAreWhatLookingUpEveryVoxelGives) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(60); i > 0; --i) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 40);
    const auto layout = layout_in<TypeParam>(scene.bounds(), random_division(chance, 5));
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact, random_rule(chance));
    const MergedGridView<double> view = merged_view_of<double>(grid);
    const MapStatistics told = map_statistics(view, std::span(grid.cells));

    std::vector<OwnVoxels> own(grid.cells.size());
    std::uint64_t occupied = 0;
    double all_loads = 0, voxel_tests = 0;
    for_each_voxel_of({{0, 0, 0}, view.division}, [&](const Vec3i& voxel) {
      const std::uint32_t number = cell_number(view, voxel);
      const std::uint32_t references = references_in(view, voxel);
      OwnVoxels& cell = own.at(number);
      ++cell.voxels;
      for (int axis = 0; axis < 3; ++axis) {
        cell.box.first.set(axis, std::min(cell.box.first[axis], voxel[axis]));
        cell.box.end.set(axis, std::max(cell.box.end[axis], voxel[axis] + 1));
      }
      if (references > 0) ++occupied;
      voxel_tests += references;
      all_loads += loads(view, voxel);
    });
    const auto voxels = static_cast<double>(voxel_count(view.division));
    EXPECT_EQ(told.voxels, voxel_count(view.division));
    EXPECT_EQ(told.occupied_voxels, occupied);
    EXPECT_DOUBLE_EQ(told.loads, all_loads / voxels);

    const std::vector<OwnVoxels> told_own = own_voxels(view, std::span(grid.cells));
    ASSERT_EQ(told_own.size(), own.size());
    std::vector<std::uint64_t> by_size;
    std::uint64_t expanded = 0;
    double log_expansion = 0, cells = 0, tests = 0;
    const Vec3d size = cast<double>(view.voxel_size);
    const double space = half_area(cast<double>(view.division) * size);
    for (std::size_t cell = 0; cell < own.size(); ++cell) {
      const VoxelBox& box = own[cell].box;
      const Vec3i w = box.end - box.first;
      EXPECT_EQ(told_own[cell].voxels, own[cell].voxels);
      EXPECT_EQ(told_own[cell].box.first, box.first);
      EXPECT_EQ(told_own[cell].box.end, box.end);
      EXPECT_EQ(own[cell].voxels, voxel_count(w)) << "a cell's own voxels aren't a box";
      const auto log2 = static_cast<std::size_t>(std::log2(static_cast<double>(own[cell].voxels)));
      if (log2 >= by_size.size()) by_size.resize(log2 + 1, 0);
      ++by_size[log2];
      const MergedCell& c = grid.cells[cell];
      double volume = 1;
      for (const std::uint32_t range : {c.x, c.y, c.z})
        volume *= static_cast<double>(range >> 16) - static_cast<double>(range & 0xffff);
      if (volume > static_cast<double>(own[cell].voxels)) ++expanded;
      log_expansion += std::log(volume / static_cast<double>(own[cell].voxels));
      const double share = half_area(cast<double>(w) * size) / space;
      cells += share;
      tests += share * references_in(view, box.first);
    }
    EXPECT_EQ(told.cells_by_size, by_size);
    EXPECT_EQ(told.expanded_cells, expanded);
    EXPECT_NEAR(std::log(told.mean_expansion), log_expansion / static_cast<double>(own.size()), 1e-9);
    EXPECT_NEAR(told.ray.cells, cells, 1e-9 * cells);
    EXPECT_NEAR(told.ray.tests, tests, 1e-9 * (1 + tests));
    // With what is skipped, every voxel by itself.
    const double all = voxels * half_area(size) / space;
    EXPECT_NEAR(told.ray.cells + told.ray.voxels_skipped, all, 1e-9 * all);
    EXPECT_LE(told.ray.tests, voxel_tests * half_area(size) / space * (1 + 1e-9));

    const std::uint64_t top = voxel_count(view.top), words = grid.voxel_map.size();
    EXPECT_EQ(told.words.front(), top);
    // Some only fill up units.
    EXPECT_LE(std::accumulate(told.words.begin(), told.words.end(), std::uint64_t{0}), words);
  }
}

// The same grid with a map of blocks is expected to cost less by the blocks that are empty.
TYPED_TEST(MapStatisticsOf, EmptyBlocksOfALargeMapAreOneCellEach) {
  Chance& chance = this->chance_;
  TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 8);
  const Vec3i n{chance.whole(260, 270), chance.whole(260, 270), chance.whole(260, 270)};
  const auto layout = layout_in<TypeParam>(scene.bounds(), n);
  const Structure grid = build_structure(scene.view(), layout, Overlap::exact);
  const GridView<double> view = view_of<double>(grid);
  ASSERT_GT(view.block_log2, 0) << "choose a finer division";
  const MapStatistics told = map_statistics(view, std::span(grid.references));

  const Vec3d size = cast<double>(view.voxel_size);
  double cells = 0, all_loads = 0;
  for_each_voxel_of({{0, 0, 0}, n}, [&](const Vec3i& voxel) {
    const int log2 = look_up(view, voxel).side_log2;
    all_loads += log2 == 0 ? 2 : 1;
    Vec3i w{1, 1, 1};
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t first = voxel[axis] >> log2 << log2;
      if (first != voxel[axis]) return; // counted at the block's first voxel
      w.set(axis, std::min(1 << log2, n[axis] - first));
    }
    cells += half_area(cast<double>(w) * size);
  });
  const double space = half_area(cast<double>(n) * size);
  const auto voxels = static_cast<double>(told.voxels);
  EXPECT_NEAR(told.ray.cells, cells / space, 1e-6 * cells / space);
  EXPECT_NEAR(told.ray.cells + told.ray.voxels_skipped, voxels * half_area(size) / space, 1e-6);
  // Empty voxels of blocks that have a map take two loads as well: look_up tells them by their side.
  EXPECT_DOUBLE_EQ(told.loads, all_loads / voxels);
  EXPECT_EQ(told.words.at(0) + told.words.at(1), grid.voxel_map.size());
}

// Lines through the space, all equally likely: a direction, and a place in a disc at right angles to it.
TYPED_TEST(MapStatisticsOf, RandomLinesMeetAsManyCellsAsExpected) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(3); i > 0; --i) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 30);
    const auto layout = layout_in<TypeParam>(scene.bounds(), random_division(chance, 4));
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact, random_rule(chance));
    const MergedGridView<double> view = merged_view_of<double>(grid);
    const MapStatistics told = map_statistics(view, std::span(grid.cells));
    const std::vector<OwnVoxels> own = own_voxels(view, std::span(grid.cells));

    const Vec3d size = cast<double>(view.voxel_size), whole = cast<double>(view.division) * size;
    const double radius = length(whole) / 2;
    double lines = 0, cells = 0, squares = 0;
    for (int line = 0; line < 4000; ++line) {
      const Vec3d direction = chance.direction(), u = across(chance, direction), v = cross(direction, u);
      const double a = chance.uniform(-radius, radius), b = chance.uniform(-radius, radius);
      const Vec3d origin = whole * 0.5 + u * a + v * b;
      if (!meets(origin, direction, {0, 0, 0}, whole)) continue;
      double met = 0;
      for (const OwnVoxels& cell : own) {
        if (meets(origin, direction, cast<double>(cell.box.first) * size, cast<double>(cell.box.end) * size))
          ++met;
      }
      ++lines;
      cells += met;
      squares += met * met;
    }
    const double mean = cells / lines, deviation = std::sqrt(std::max(0.0, squares / lines - mean * mean));
    EXPECT_NEAR(told.ray.cells, mean, 6 * deviation / std::sqrt(lines) + 1e-9) << own.size() << " cells";
  }
}

} // namespace
} // namespace masu
