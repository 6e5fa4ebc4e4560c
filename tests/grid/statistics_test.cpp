// What a grid lists against what each primitive says of each voxel, and the numbers told of it; the same
// bytes for any number of threads.
#include "libgrid/statistics/statistics.h"
#include "tests/grid/lists.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>

#include <algorithm>

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
class Built : public RandomTest {};
TYPED_TEST_SUITE(Built, Reals);

TYPED_TEST(Built, EveryVoxelListsItsPrimitivesInRisingOrder) {
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(60); i > 0; --i) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 60);
    const auto layout = layout_in<TypeParam>(scene.bounds(), random_division(chance, 24));
    const Overlap overlap = any_overlap(chance);
    const Structure grid = build_structure(scene.view(), layout, overlap);
    ASSERT_EQ(grid.block_log2, 0);
    ASSERT_EQ(lists_of<TypeParam>(grid), lists_of(scene, layout, overlap));
  }
}

// More primitives than one piece holds, and crowded and lonely buckets side by side.
TYPED_TEST(Built, ManyPrimitivesAreListedLikeFew) {
  Chance& chance = this->chance_;
  TestScene<TypeParam> scene;
  add_triangles(scene, chance, 20'000, 0.002, 0.01);
  const auto layout = layout_in<TypeParam>(scene.bounds(), {70, 50, 60});
  ASSERT_EQ(lists_of<TypeParam>(build_structure(scene.view(), layout, Overlap::exact)),
            lists_of(scene, layout, Overlap::exact));
}

// Beyond 2²³ voxels the map has two levels; what it leads to is the same.
TYPED_TEST(Built, MapsOfTwoLevelsLeadToTheSameLists) {
  Chance& chance = this->chance_;
  for (const Vec3i& division : {Vec3i{203, 207, 211}, {1, 3000, 3001}, {65535, 131, 1}}) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 12);
    scene.spheres.clear(); // slow in so many voxels
    scene.cones.clear();
    scene.triangles.push_back(triangle_of<TypeParam>({-1, -1, -1}, {1, 1, 1}, {1, TypeParam(0.9), 1}));
    const auto layout = layout_in<TypeParam>(scene.bounds(), division);
    const Structure grid = build_structure(scene.view(), layout, Overlap::exact);
    ASSERT_GT(grid.block_log2, 0);
    ASSERT_EQ(lists_of<TypeParam>(grid), lists_of(scene, layout, Overlap::exact));
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
    const GridStatistics told = grid_statistics(view, grid.references);

    std::vector<std::uint64_t> counts; // of the occupied voxels
    std::uint64_t references = 0;
    for_each_voxel_of({{0, 0, 0}, layout.division}, [&](const Vec3i& voxel) {
      const std::uint32_t count = references_in(view, voxel);
      if (count > 0) counts.push_back(count);
      references += count;
    });
    std::sort(counts.begin(), counts.end());
    EXPECT_EQ(told.cells, voxel_count(layout.division));
    EXPECT_EQ(told.occupied_cells, counts.size());
    EXPECT_EQ(told.references, references);
    EXPECT_EQ(occupied_voxels(scene.view(), layout, overlap), counts.size());
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

} // namespace
} // namespace masu
