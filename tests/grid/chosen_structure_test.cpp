// The choice among structures by tracing some rays through each.
#include "libgrid/build/chosen_structure.h"
#include "libgrid/build/sampled_costs.h"
#include "libscene/base/error.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>

namespace masu {
namespace {

template <class Stored>
Grid built(TestScene<Stored>& scene, GridKind kind, Processor processor = Processor::gpu) {
  BuildOptions options;
  options.grid.kind = kind;
  options.processor = processor;
  return build_chosen(*cpu_builder(scene.view()), {scene.bounds(), Hash{1, 2}}, options).grid;
}

template <class Stored>
class Fastest : public RandomTest {};
TYPED_TEST_SUITE(Fastest, Reals);

// Long and thin, in all directions through each other: no boxes part them.
template <class Stored>
TestScene<Stored> needles(Chance& chance) {
  TestScene<Stored> scene;
  for (int i = 0; i < 4000; ++i) {
    const Vec3d at = chance.in_cube(1), along = chance.direction() * 0.5;
    const auto near = [&](const Vec3d& point) { return cast<Stored>(point + chance.in_cube(0.004)); };
    scene.triangles.push_back(triangle_of(near(at - along), near(at + along), near(at + along)));
  }
  return scene;
}

// Small and far apart, in clusters of all sizes.
template <class Stored>
TestScene<Stored> clusters(Chance& chance) {
  TestScene<Stored> scene;
  for (int i = 0; i < 40; ++i) {
    const Vec3d center = chance.in_cube(1);
    const double size = chance.power_of_two(-12, -6);
    for (int j = 0; j < 200; ++j) {
      const Vec3d at = center + chance.in_cube(size);
      const auto near = [&] { return cast<Stored>(at + chance.in_cube(size * 0.1)); };
      scene.triangles.push_back(triangle_of(near(), near(), near()));
    }
  }
  return scene;
}

constexpr Processor processors[] = {Processor::gpu, Processor::cpu};

TYPED_TEST(Fastest, NoCandidateOfItsKindIsExpectedToBeClearlyFaster) {
  for (std::int64_t i = cases(50); i > 0; --i) {
    TestScene<TypeParam> scene =
        SceneMaker<TypeParam>(this->chance_, this->chance_.power_of_two(-10, 20)).scene();
    for (const Processor processor : processors) {
      const auto time_of = [&](const Grid& grid) {
        return expected_time(sampled_costs(scene.view(), grid), grid.kind, processor);
      };
      constexpr double clearly = 0.95;
      const double automatic = time_of(built(scene, GridKind::automatic, processor)),
                   fastest = time_of(built(scene, GridKind::fastest, processor));
      EXPECT_LE(clearly * fastest, automatic);
      EXPECT_LE(clearly * automatic, time_of(built(scene, GridKind::irregular, processor)));
      EXPECT_LE(clearly * fastest, time_of(built(scene, GridKind::hierarchy, processor)));
    }
  }
}

TYPED_TEST(Fastest, IsAGridWhereBoxesOverlapAndAHierarchyWhereSpaceIsEmpty) {
  TestScene<TypeParam> overlapping = needles<TypeParam>(this->chance_),
                       sparse = clusters<TypeParam>(this->chance_);
  EXPECT_NE(built(overlapping, GridKind::fastest).kind, GridKind::hierarchy);
  EXPECT_EQ(built(sparse, GridKind::fastest).kind, GridKind::hierarchy);
}

TYPED_TEST(Fastest, IsTheSameForAnyNumberOfThreads) {
  TestScene<TypeParam> scene = clusters<TypeParam>(this->chance_);
  for (const GridKind kind : {GridKind::uniform, GridKind::automatic, GridKind::fastest}) {
    compare_threads([&] { return built(scene, kind); }, expect_same);
  }
}

TYPED_TEST(Fastest, CostsAreTheSameForAnyNumberOfThreads) {
  TestScene<TypeParam> scene = clusters<TypeParam>(this->chance_);
  for (const GridKind kind : {GridKind::uniform, GridKind::irregular, GridKind::hierarchy}) {
    const Grid grid = built(scene, kind);
    const auto expect_same_costs = [](const SampledCosts& one, const SampledCosts& many) {
      for (const auto set : {&SampledCosts::across, &SampledCosts::aimed, &SampledCosts::scattered}) {
        EXPECT_EQ((one.*set).steps, (many.*set).steps);
        EXPECT_EQ((one.*set).tests, (many.*set).tests);
        EXPECT_GT((one.*set).steps, 0);
      }
      EXPECT_GT(one.aimed.tests, 0);
      EXPECT_GT(one.scattered.tests, 0);
    };
    compare_threads([&] { return sampled_costs(scene.view(), grid); }, expect_same_costs);
  }
}

TYPED_TEST(Fastest, IsAUniformGridForASceneWithoutPrimitives) {
  TestScene<TypeParam> scene;
  EXPECT_EQ(built(scene, GridKind::fastest).kind, GridKind::uniform);
}

TEST(FastestAnywhere, IsAGridWhereNoHierarchyReaches) {
  TestScene<double> scene;
  for (const double at : {-1e20, 1e20})
    scene.spheres.push_back(sphere_of<double>({at, at, at}, 1e18));
  EXPECT_NE(built(scene, GridKind::fastest).kind, GridKind::hierarchy);
}

TEST(FastestAnywhere, IsAGridWhereAMergeRuleOrADivisionIsGiven) {
  const auto kind = [](StructureChoice structure, GridKind merge, const char* division,
                       HierarchyQuality quality = HierarchyQuality::high) {
    return kind_of(structure, merge, parse_division(division), quality);
  };
  EXPECT_EQ(kind(StructureChoice::fastest, GridKind::automatic, "auto"), GridKind::fastest);
  EXPECT_EQ(kind(StructureChoice::fastest, GridKind::automatic, "auto", HierarchyQuality::fast),
            GridKind::fastest);
  for (const StructureChoice structure : {StructureChoice::fastest, StructureChoice::grid}) {
    EXPECT_EQ(kind(structure, GridKind::automatic, "woo:2"), GridKind::automatic);
    EXPECT_EQ(kind(structure, GridKind::x, "auto"), GridKind::x);
    EXPECT_THROW(kind(structure, GridKind::x, "auto", HierarchyQuality::fast), Error);
  }
  EXPECT_EQ(kind(StructureChoice::grid, GridKind::automatic, "auto"), GridKind::automatic);
  EXPECT_EQ(kind(StructureChoice::hierarchy, GridKind::automatic, "8"), GridKind::hierarchy);
  EXPECT_THROW(kind(StructureChoice::hierarchy, GridKind::x, "auto"), Error);
}

} // namespace
} // namespace masu
