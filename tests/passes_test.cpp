// Grids built by passes, run as plain loops, against those built by the CPU.
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/same_grid.h"
#include "tests/serial_executor.h"

namespace masu {
namespace {

template <class Stored>
class Executor : public testing::Test {};
using Stores = testing::Types<float, double>;
TYPED_TEST_SUITE(Executor, Stores);

TYPED_TEST(Executor, BuildTheSameUniformGrid) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  SerialExecutor executor;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Overlap overlap = chance.one_in(2) ? Overlap::exact : Overlap::box;
    const GridLayout layout = random_lattice<TypeParam>(chance, scene.bounds());
    expect_same(build_grid(scene.view(), layout, overlap),
                as_grid(uniform_grid(executor, scene.view(), layout, overlap)));
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(Executor, BuildTheSameUniformGridOfBlocks) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  SerialExecutor executor;
  for (std::int64_t s = cases(3); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, 1).fine();
    GridLayout layout = random_lattice<TypeParam>(chance, scene.bounds());
    layout.division = {chance.whole(200, 260), chance.whole(220, 250), chance.whole(220, 250)};
    const Grid grid = build_grid(scene.view(), layout, Overlap::exact);
    EXPECT_GT(grid.block_log2, 0);
    expect_same(grid, as_grid(uniform_grid(executor, scene.view(), layout, Overlap::exact)));
  }
}

TYPED_TEST(Executor, BuildTheSameIrregularGrid) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  SerialExecutor executor;
  std::int64_t divided = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const auto [layout, overlap, options] = random_irregular_case<TypeParam>(chance, scene.bounds());
    const Grid grid = build_grid(scene.view(), layout, overlap, options);
    divided += grid.voxel_map.size() > voxel_count(layout.division) + 3;
    expect_same(grid, as_grid(irregular_grid(executor, scene.view(), layout, overlap, options)));
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
  EXPECT_GT(divided, cases(100));
}

TYPED_TEST(Executor, BuildTheSameOfNothing) {
  SerialExecutor executor;
  TestScene<TypeParam> scene;
  const GridLayout layout{{{-1, -1, -1}, {1, 1, 1}}, {3, 4, 5}, 0};
  GridOptions options;
  options.kind = GridKind::irregular;
  expect_same(build_grid(scene.view(), layout, Overlap::exact),
              as_grid(uniform_grid(executor, scene.view(), layout, Overlap::exact)));
  expect_same(build_grid(scene.view(), layout, Overlap::exact, options),
              as_grid(irregular_grid(executor, scene.view(), layout, Overlap::exact, options)));
}

} // namespace
} // namespace masu
