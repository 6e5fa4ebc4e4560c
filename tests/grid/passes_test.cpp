// Grids built by passes as a device runs them, as plain loops, against those built by the CPU.
#include "libgrid/build/passes/cluster_passes.h"
#include "libgrid/build/passes/host_executor.h"
#include "libgrid/build/passes/refit_passes.h"
#include "tests/grid/device_like_executor.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace masu {
namespace {

using Executors = RandomTest;

template <class Stored>
class Executor : public RandomTest {};
using Stores = testing::Types<float, double>;
TYPED_TEST_SUITE(Executor, Stores);

TYPED_TEST(Executor, BuildTheSameUniformGrid) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Overlap overlap = chance.one_in(2) ? Overlap::exact : Overlap::box;
    const GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    expect_same(build_grid(scene.view(), layout, overlap),
                on_host(uniform_grid(executor, scene.view(), layout, overlap)).grid);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(Executor, BuildTheSameUniformGridOfBlocks) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(3); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, 1).fine();
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    layout.division = {chance.whole(200, 260), chance.whole(220, 250), chance.whole(220, 250)};
    const Grid grid = build_grid(scene.view(), layout, Overlap::exact);
    EXPECT_GT(grid.block_log2, 0);
    expect_same(grid, on_host(uniform_grid(executor, scene.view(), layout, Overlap::exact)).grid);
  }
}

TYPED_TEST(Executor, BuildTheSameMergedGrid) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  std::int64_t divided = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    auto [layout, overlap, options] = random_irregular_case<TypeParam>(chance, scene.bounds());
    if (chance.one_in(3)) options.kind = chance.one_of({GridKind::x, GridKind::balance});
    const Grid grid = build_grid(scene.view(), layout, overlap, options);
    divided += grid.voxel_map.size() > voxel_count(layout.division) + 3;
    expect_same(grid, on_host(merged_grid(executor, scene.view(), layout, overlap, options)).grid);
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
  EXPECT_GT(divided, cases(75));
}

TYPED_TEST(Executor, BuildTheSameFastHierarchy) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(100); s > 0; --s) {
    TestScene<TypeParam> scene = s % 10 == 0
                                     ? scattered_scene<TypeParam>(chance, 5000)
                                     : SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const GridLayout layout = hierarchy_layout(scene);
    expect_same(
        hierarchy_grid(scene.view(), layout, HierarchyQuality::fast),
        on_host(collapsed_hierarchy(executor, layout, clustered_hierarchy(executor, scene.view(), layout)))
            .grid);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(Executor, RefitTheSameHierarchy) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(30); s > 0; --s) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 1000);
    Grid grid = hierarchy_of(scene, any_quality(chance)), other = grid;
    move_primitives(chance, scene, chance.power_of_two(-10, 1));
    const GridLayout layout = hierarchy_layout(scene);
    EXPECT_TRUE(refit_hierarchy(scene.view(), layout, grid));
    refit(executor, scene.view(), layout.margin, other.nodes, other.references);
    expect_same(grid, other);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

// On the host's cores one part after another; rows of many pairs all at once.
TYPED_TEST(Executor, BuildTheSameMergedGridOfManyParts) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(4); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, 1).fine();
    while (scene.view().primitive_count() < 100000)
      scene.triangles.insert(scene.triangles.end(), scene.triangles.begin(), scene.triangles.end());
    GridOptions options = random_grid_options(chance);
    options.nested_log2 = std::min(options.nested_log2, 2);
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    layout.division = {chance.whole(1, 60), chance.whole(1, 30), chance.whole(1, 30)};
    if (s == 1) layout.division = {1, 1, 1};
    const Grid grid = build_grid(scene.view(), layout, Overlap::box, options);
    expect_same(grid, on_host(merged_grid(executor, scene.view(), layout, Overlap::box, options)).grid);
    ASSERT_FALSE(this->HasFailure()) << described(grid);
  }
}

TYPED_TEST(Executor, BuildTheSameOfNothing) {
  DeviceLikeExecutor executor;
  TestScene<TypeParam> scene;
  const GridLayout layout{{{-1, -1, -1}, {1, 1, 1}}, {3, 4, 5}, 0};
  expect_same(build_grid(scene.view(), layout, Overlap::exact),
              on_host(uniform_grid(executor, scene.view(), layout, Overlap::exact)).grid);
  for (const GridKind kind : {GridKind::x, GridKind::balance, GridKind::irregular}) {
    const GridOptions options{kind};
    expect_same(build_grid(scene.view(), layout, Overlap::exact, options),
                on_host(merged_grid(executor, scene.view(), layout, Overlap::exact, options)).grid);
  }
}

// Some keys twice, in any order; each one's value is its place in it.
struct EmitKeys {
  static constexpr std::uint64_t rows = 3; // an item
  const std::vector<std::uint64_t>& keys;

  std::uint64_t size(std::uint64_t) const { return rows; }
  template <class Add>
  void operator()(std::uint64_t i, std::uint64_t first_row, std::uint64_t end_row, const Add& add) const {
    for (std::uint64_t k = rows * i + first_row; k < rows * i + std::min(end_row, rows); ++k)
      add(keys[k], static_cast<std::uint32_t>(k));
  }
};

// A division's keys have up to 49 bits: the voxels of 65535³, and the voxels that fill its last blocks.
TEST_F(Executors, SortKeysOfAnyWidth) {
  constexpr int widest = 49;
  EXPECT_EQ(std::bit_width(StorageOrder({largest_division, largest_division, largest_division}, 3).size()),
            widest);
  for (int bits = 1; bits <= widest; ++bits) {
    SCOPED_TRACE(bits);
    const std::uint64_t end = std::uint64_t{1} << bits;
    std::vector<std::uint64_t> keys{0, end - 1, end / 2};
    while (keys.size() < 5000 * EmitKeys::rows)
      keys.push_back(chance_.one_in(4) ? keys[chance_.index(keys.size())] : chance_.engine()() % end);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> expected;
    for (std::uint32_t k = 0; k < keys.size(); ++k)
      expected.emplace_back(keys[k], k);
    std::sort(expected.begin(), expected.end());
    const auto sort = [&](const auto& executor, std::uint64_t max_pairs) {
      return executor.template emit_sorted<std::uint32_t>(keys.size() / EmitKeys::rows, bits, max_pairs,
                                                          EmitKeys{keys});
    };
    const auto check = [&](const auto& executor) {
      const auto sorted = sort(executor, keys.size());
      ASSERT_TRUE(sorted.has_value());
      ASSERT_EQ(sorted->keys.size(), keys.size());
      for (std::size_t k = 0; k < keys.size(); ++k)
        ASSERT_EQ(std::pair(sorted->keys[k], sorted->values[k]), expected[k]) << k;
      EXPECT_FALSE(sort(executor, keys.size() - 1).has_value());
    };
    check(TbbExecutor());
    check(DeviceLikeExecutor());
  }
}

} // namespace
} // namespace masu
