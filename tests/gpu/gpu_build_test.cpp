// Grids built on the GPU against the CPU's, byte for byte. Skipped, and said so, where there is no CUDA
// device.
#include "libgrid/build/builder.h"
#include "libscene/cuda/cuda_device.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/same_grid.h"

namespace masu {
namespace {

template <class Stored>
class BuiltOnTheGpu : public testing::Test {
protected:
  void SetUp() override {
    std::string why;
    if (!cuda_available(why)) GTEST_SKIP() << "no GPU, nothing was compared: " << why;
  }
  RandomSeed seed_;
};
using Stores = testing::Types<float, double>;
TYPED_TEST_SUITE(BuiltOnTheGpu, Stores);

TYPED_TEST(BuiltOnTheGpu, AUniformGridIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(150); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Overlap overlap = chance.one_in(2) ? Overlap::exact : Overlap::box;
    const GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    expect_same(cpu_builder(scene.view())->build(layout, overlap),
                cuda_builder(scene.view())->build(layout, overlap));
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(BuiltOnTheGpu, AUniformGridOfBlocksIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(3); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, 1).fine();
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    layout.division = {chance.whole(200, 260), chance.whole(220, 250), chance.whole(220, 250)};
    expect_same(cpu_builder(scene.view())->build(layout, Overlap::exact),
                cuda_builder(scene.view())->build(layout, Overlap::exact));
  }
}

TYPED_TEST(BuiltOnTheGpu, AMergedGridIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(150); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    auto [layout, overlap, options] = random_irregular_case<TypeParam>(chance, scene.bounds());
    if (chance.one_in(3)) options.kind = chance.one_of({GridKind::x, GridKind::balance});
    const Grid grid = cpu_builder(scene.view())->build(layout, overlap, options);
    expect_same(grid, cuda_builder(scene.view())->build(layout, overlap, options));
    ASSERT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
  }
}

TYPED_TEST(BuiltOnTheGpu, AFastHierarchyIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  GridOptions options{GridKind::hierarchy};
  options.quality = HierarchyQuality::fast;
  for (std::int64_t s = cases(150); s > 0; --s) {
    TestScene<TypeParam> scene = s % 10 == 0
                                     ? scattered_scene<TypeParam>(chance, 30'000)
                                     : SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const GridLayout layout = hierarchy_layout(scene);
    expect_same(cpu_builder(scene.view())->build(layout, Overlap::exact, options),
                cuda_builder(scene.view())->build(layout, Overlap::exact, options));
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(BuiltOnTheGpu, ARefittedHierarchyIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  for (std::int64_t s = cases(50); s > 0; --s) {
    TestScene<TypeParam> scene = scattered_scene<TypeParam>(chance, 3000);
    Grid cpu = hierarchy_of(scene, any_quality(chance)), gpu = cpu;
    move_primitives(chance, scene, chance.power_of_two(-10, 1));
    const GridLayout layout = hierarchy_layout(scene);
    EXPECT_TRUE(cpu_builder(scene.view())->refit(layout, cpu));
    EXPECT_TRUE(cuda_builder(scene.view())->refit(layout, gpu));
    expect_same(cpu, gpu);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

// Boxes of so many parts that a block of threads divides them, and not a warp.
TYPED_TEST(BuiltOnTheGpu, AnIrregularGridOfCrowdedVoxelsIsTheSameBytes) {
  SCOPED_TRACE(this->seed_.trace());
  Chance chance(this->seed_);
  TestScene<TypeParam> scene;
  for (int i = 0; i < 30'000; ++i) {
    const Vec3d at = chance.in_cube(1) * (chance.one_in(2) ? 0.1 : 1.0);
    const auto near = [&] { return cast<TypeParam>(at + chance.in_cube(0.02)); };
    scene.triangles.push_back(triangle_of(near(), near(), near()));
    if (i % 10 == 0) scene.spheres.push_back(sphere_of<TypeParam>(at, 0.01));
    if (i % 10 == 1)
      scene.cones.push_back(cone_of<TypeParam>(at, 0.01, at + chance.direction() * 0.02, 0.005));
  }
  GridOptions options;
  options.kind = GridKind::irregular;
  for (const Vec3i& division : {Vec3i{1, 1, 1}, Vec3i{3, 2, 1}, Vec3i{20, 20, 20}}) {
    GridLayout layout = random_layout<TypeParam>(chance, scene.bounds());
    layout.division = division;
    const auto cpu = cpu_builder(scene.view()), gpu = cuda_builder(scene.view());
    for (const Overlap overlap : {Overlap::exact, Overlap::box}) {
      expect_same(cpu->build(layout, overlap), gpu->build(layout, overlap));
      expect_same(cpu->build(layout, overlap, options), gpu->build(layout, overlap, options));
    }
  }
}

TYPED_TEST(BuiltOnTheGpu, AGridOfNothingIsTheSameBytes) {
  TestScene<TypeParam> scene;
  const GridLayout layout{{{-1, -1, -1}, {1, 1, 1}}, {3, 4, 5}, 0};
  const auto cpu = cpu_builder(scene.view()), gpu = cuda_builder(scene.view());
  for (const GridKind kind :
       {GridKind::uniform, GridKind::x, GridKind::balance, GridKind::irregular, GridKind::hierarchy})
    expect_same(cpu->build(layout, Overlap::exact, {kind}), gpu->build(layout, Overlap::exact, {kind}));
}

} // namespace
} // namespace masu
