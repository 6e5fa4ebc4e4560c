// How many voxels each rule asks for, and how rules are written.
#include "libgrid/grid/division.h"
#include "libgrid/structure/builder.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/refused.h"

#include <gtest/gtest.h>

namespace masu {
namespace {

using AutomaticDivision = RandomTest;
using AutomaticDivisions = RandomTest;
using CostModel = RandomTest;

using RuleKind = DivisionRule::Kind;

// --- How rules are written -------------------------------------------------------------------------------

TEST(DivisionRules, AreReadAsTheyAreWritten) {
  EXPECT_EQ(parse_division("auto").kind, RuleKind::automatic);
  EXPECT_EQ(parse_division("17").fixed, (Vec3i{17, 17, 17}));
  EXPECT_EQ(parse_division("1x2x65535").fixed, (Vec3i{1, 2, 65535}));
  EXPECT_EQ(parse_division("1x2x3").kind, RuleKind::fixed);
  const auto expect = [](const char* text, RuleKind kind, double parameter) {
    const DivisionRule rule = parse_division(text);
    EXPECT_EQ(rule.kind, kind) << text;
    EXPECT_EQ(rule.parameter, parameter) << text;
    EXPECT_EQ(rule.text, text);
  };
  expect("cube-root:3", RuleKind::cube_root, 3);
  expect("woo:0.5", RuleKind::woo, 0.5);
  expect("heterogeneous:2.25", RuleKind::heterogeneous, 2.25);
  expect("cleary:1e2", RuleKind::cleary, 100);
}

class BadDivision : public testing::TestWithParam<const char*> {};

TEST_P(BadDivision, IsAUsageError) {
  EXPECT_TRUE(is_refused_with(
      ErrorCode::usage, "division", [] { parse_division(GetParam()); }, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(DivisionRules, BadDivision,
                         testing::Values("", "0", "-1", "65536", "99999999999", "1.5", "1x2", "1x2x3x4", "x",
                                         "1x", "x1", "1x2x", "1xx2", "1x2x0", "1x2x65536", " 4", "4 ", "+4",
                                         "0x10", "four", "Auto", "auto:1", "woo", "woo:", "woo:0", "woo:-1",
                                         "woo:nan", "woo:inf", "woo:1e999", "woo:1x", "woo:1 ", "woo: 1",
                                         "cleary:one", "klimaszewski:1", ":1", "cube-root:1:2"));

// --- What they ask for -----------------------------------------------------------------------------------

DivisionStatistics statistics_of(std::uint64_t primitives) {
  DivisionStatistics statistics;
  statistics.all.primitives = statistics.dense.primitives = primitives;
  return statistics;
}

Vec3i chosen(const char* rule, std::uint64_t primitives, const Vec3d& extent) {
  return choose_division(parse_division(rule), statistics_of(primitives), Boxd{{0, 0, 0}, extent}, 0);
}

TEST(DivisionRules, FollowTheirFormulas) {
  EXPECT_EQ(chosen("7x8x9", 1000, {1, 1, 1}), (Vec3i{7, 8, 9}));
  // D·∛N whatever the space's shape.
  EXPECT_EQ(chosen("cube-root:1", 1000, {1, 2, 4}), (Vec3i{10, 10, 10}));
  EXPECT_EQ(chosen("cube-root:2.5", 1000, {1, 2, 4}), (Vec3i{25, 25, 25}));
  // D·∛N along the longest side.
  EXPECT_EQ(chosen("woo:2", 1000, {1, 2, 4}), (Vec3i{5, 10, 20}));
  // D·w·∛(N/V): here ∛(N/V) = ∛(8000/8) = 10.
  EXPECT_EQ(chosen("heterogeneous:1", 8000, {1, 2, 4}), (Vec3i{10, 20, 40}));
  EXPECT_EQ(chosen("heterogeneous:0.5", 8000, {1, 2, 4}), (Vec3i{5, 10, 20}));
  // w·∛(λN/V).
  EXPECT_EQ(chosen("cleary:1", 8000, {1, 2, 4}), (Vec3i{10, 20, 40}));
  EXPECT_EQ(chosen("cleary:8", 8000, {1, 2, 4}), (Vec3i{20, 40, 80}));
}

TEST(DivisionRules, RoundToTheNearestAndKeepAVoxelAnAxis) {
  EXPECT_EQ(chosen("cube-root:1.04", 1000, {1, 1, 1}), (Vec3i{10, 10, 10}));
  EXPECT_EQ(chosen("cube-root:1.06", 1000, {1, 1, 1}), (Vec3i{11, 11, 11}));
  EXPECT_EQ(chosen("woo:1", 1000, {100, 100, 1}), (Vec3i{10, 10, 1}));
  EXPECT_EQ(chosen("cube-root:0.001", 8, {1, 1, 1}), (Vec3i{1, 1, 1}));
  for (const char* const rule : {"cube-root:1", "woo:1", "heterogeneous:1", "cleary:1", "auto"})
    EXPECT_EQ(chosen(rule, 0, {1, 1, 1}), (Vec3i{1, 1, 1})) << rule;
}

// λN voxels, whatever the space's shape: a thin side keeps one voxel and leaves its share to the others.
TEST(DivisionRules, ClearyMakesAboutLambdaTimesNVoxelsOfFlatSpacesToo) {
  for (const double thin : {1.0, 0.1, 1e-3, 1e-9}) {
    for (const double narrow : {1.0, 0.1, 1e-3}) {
      const Vec3i division = chosen("cleary:4", 25'000, {1, narrow, thin});
      const double voxels = static_cast<double>(voxel_count(division));
      EXPECT_GT(voxels, 70'000) << narrow << ' ' << thin;
      EXPECT_LT(voxels, 140'000) << narrow << ' ' << thin;
    }
  }
}

TEST(DivisionRules, RefuseMoreVoxelsThanAnAxisCanHave) {
  EXPECT_EQ(chosen("cube-root:65535", 1, {1, 1, 1}), (Vec3i{65535, 65535, 65535}));
  for (const char* const rule :
       {"cube-root:65536", "cube-root:1e300", "woo:1e6", "heterogeneous:1e9", "cleary:1e18"})
    EXPECT_TRUE(is_refused_with(ErrorCode::usage, "division", [&] {
      chosen(rule, 1000, {1, 1, 1});
    })) << rule;
}

// --- Spaces ----------------------------------------------------------------------------------------------

template <class Real>
class Spaces : public RandomTest {};
TYPED_TEST_SUITE(Spaces, Reals);

TYPED_TEST(Spaces, HoldTheBoundsAndTheirMargin) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t i = cases(10'000); i > 0; --i) {
    const double scale = chance.power_of_two(-20, 30);
    const Vec3d at = chance.in_cube(chance.one_of({0.0, scale, 1000 * scale}));
    Boxd box = join(Boxd{at, at}, at + chance.in_cube(scale));
    if (chance.one_in(3)) box.max.set(2, box.min.z);
    if (largest_magnitude(box) == 0) continue;
    // What the padding leaves beyond the margin covers the rounding of the space's own corners.
    const Boxd needed = grown(box, rounding_margin<Real>(box) * 1.5);
    for (const SpaceRule rule : {SpaceRule::tight, SpaceRule::cube}) {
      const Boxd space = space_of<Real>(box, rule);
      EXPECT_TRUE(contains(space, needed.min) && contains(space, needed.max))
          << described(box.min) << described(box.max);
      EXPECT_TRUE(kept<Real>(space.min) == space.min && kept<Real>(space.max) == space.max)
          << "not in numbers that Real holds: " << described(space.min) << described(space.max);
      if (rule == SpaceRule::cube) {
        EXPECT_EQ(space.min, -space.max);
        EXPECT_EQ(space.max, (Vec3d{space.max.x, space.max.x, space.max.x}));
        EXPECT_LE(space.max.x, largest_magnitude(box) * (1 + 1e-4));
      }
      if (testing::Test::HasFailure()) return;
    }
  }
}

TYPED_TEST(Spaces, OfNothingCanBeDividedAllTheSame) {
  for (const SpaceRule rule : {SpaceRule::tight, SpaceRule::cube})
    EXPECT_FALSE(is_empty(space_of<TypeParam>(empty_box<double>(), rule)));
  const GridLayout layout = make_grid_layout<TypeParam>(empty_box<double>(), SpaceRule::tight,
                                                        parse_division("4"), statistics_of(0));
  EXPECT_EQ(layout.division, (Vec3i{4, 4, 4}));
  EXPECT_EQ(layout.margin, 0);
}

// --- The cost model --------------------------------------------------------------------------------------

TestScene<float> scattered(Chance& chance, int triangles, double size) {
  TestScene<float> scene;
  add_triangles(scene, chance, triangles, size);
  return scene;
}

// Between so many times what is made.
void expect_about_the_references_made(TestScene<float>& scene, const Vec3i& division, double least,
                                      double most) {
  const auto layout = layout_in<float>(scene.bounds(), division);
  const SceneView<float> view = scene.view();
  const double expected = expected_references(division_statistics(view).all, layout);
  const auto made = static_cast<double>(build_structure(view, layout, Overlap::exact).references.size());
  EXPECT_TRUE(expected > made * least && expected < made * most)
      << expected << ", made " << made << ": " << division.x << ' ' << division.y << ' ' << division.z;
}

TEST_F(CostModel, ExpectsAboutTheReferencesThatAreMade) {
  for (std::int64_t i = cases(20); i > 0; --i) {
    TestScene<float> scene = scattered(chance_, 2000, chance_.power_of_two(-6, -1));
    expect_about_the_references_made(scene, random_division(chance_, 40), 0.85, 1.25);
  }
}

// Voxels not much larger than the margin, as far from zero as that takes.
TEST_F(CostModel, ExpectsTheReferencesThatTheMarginMakes) {
  for (std::int64_t i = cases(20); i > 0; --i) {
    const double size = chance_.power_of_two(-10, -2), far = chance_.power_of_two(4, 12);
    TestScene<float> scene = scattered(chance_, 300, size);
    for_each_points(scene, [&](auto&... corners) { ((corners.x += static_cast<float>(far)), ...); });
    const auto most = static_cast<int>(std::min(40.0, 4 / rounding_margin<float>(scene.bounds())));
    SCOPED_TRACE(testing::Message() << "size " << size << " at " << far);
    expect_about_the_references_made(scene, random_division(chance_, std::max(2, most)), 0.8, 1.6);
  }
}

TEST_F(CostModel, AddsUpExtentsAndProjections) {
  TestScene<double> scene;
  scene.triangles.push_back(triangle_of<double>({0, 0, 0}, {2, 0, 0}, {0, 3, 0}));
  SurfaceSums sums = division_statistics(scene.view()).all;
  EXPECT_EQ(sums.primitives, 1U);
  EXPECT_EQ(sums.extents, (Vec3d{2, 3, 0}));
  EXPECT_EQ(sums.projections, (Vec3d{0, 0, 3}));
  scene.spheres.push_back({{5, 5, 5}, -2});
  sums = division_statistics(scene.view()).all;
  EXPECT_EQ(sums.primitives, 2U);
  EXPECT_EQ(sums.extents, (Vec3d{6, 7, 4}));
  // Both sides of the sphere: twice a disc of radius 2.
  EXPECT_NEAR(sums.projections.x, 8 * 3.14159265358979, 1e-9);
}

// The dense box is where nearly all primitives are; a far-off few don't count, nor how large a floor is.
TEST_F(CostModel, LooksAtTheDenseBox) {
  TestScene<float> scene = scattered(chance_, 1000, 0.01);
  scene.triangles.push_back(triangle_of<float>({-500, -500, -1}, {500, -500, -1}, {0, 500, -1}));
  const DivisionStatistics statistics = division_statistics(scene.view());
  EXPECT_EQ(statistics.all.primitives, 1001U);
  EXPECT_GE(statistics.dense.primitives, 800U);
  for (int axis = 0; axis < 2; ++axis)
    EXPECT_LT(statistics.dense_box.max[axis] - statistics.dense_box.min[axis], 20);
}

template <class Stored>
GridLayout automatic_layout(TestScene<Stored>& scene) {
  return make_grid_layout<Stored>(scene.bounds(), SpaceRule::tight, {}, division_statistics(scene.view()));
}

TEST_F(AutomaticDivision, GrowsWithTheNumberOfPrimitives) {
  std::uint64_t fewer = 0;
  for (const int triangles : {10, 300, 10'000, 100'000}) {
    TestScene<float> scene = scattered(chance_, triangles, 0.5 / std::cbrt(triangles));
    const std::uint64_t voxels = voxel_count(automatic_layout(scene).division);
    EXPECT_GT(voxels, fewer);
    // Neither a voxel for each corner of each triangle, nor crowds of them in one.
    EXPECT_GT(static_cast<double>(voxels), 0.1 * triangles);
    EXPECT_LT(static_cast<double>(voxels), 100.0 * triangles + 100);
    fewer = voxels;
  }
}

TEST_F(AutomaticDivision, HasVoxelsOfAboutEqualSides) {
  TestScene<float> scene = scattered(chance_, 5000, 0.05);
  for_each_points(scene, [](auto&... corners) { ((corners = corners * Vec3f{4, 2, 1}), ...); });
  const Vec3d side = voxel_size(automatic_layout(scene));
  EXPECT_NEAR(side.x / side.z, 1, 0.2);
  EXPECT_NEAR(side.y / side.z, 1, 0.2);
}

TEST_F(AutomaticDivision, CopesWithFlatAndLonelyThings) {
  TestScene<float> floor;
  for (int i = 0; i < 400; ++i) {
    const float x = static_cast<float>(i % 20), y = static_cast<float>(i / 20);
    floor.triangles.push_back(triangle_of<float>({x, y, 7}, {x + 1, y, 7}, {x, y + 1, 7}));
  }
  const Vec3i flat = automatic_layout(floor).division;
  EXPECT_EQ(flat.z, 1);
  EXPECT_GT(flat.x, 3);
  EXPECT_LE(voxel_count(flat), 200'000U);

  TestScene<double> alone;
  alone.spheres.push_back({{1e6, 0, 0}, 1e-3});
  EXPECT_LE(voxel_count(automatic_layout(alone).division), 1000U);
}

// Rods side by side, each as long as the whole: their centers lie in one line, but not what rays meet.
TEST_F(AutomaticDivision, DividesRowsOfLongThings) {
  TestScene<float> rods;
  for (int i = 0; i < 10'000; ++i) {
    const double x = i;
    rods.cones.push_back(cone_of<float>({x, 0, 0}, 0.4, {x, 10'000, 0}, 0.4));
  }
  EXPECT_GE(automatic_layout(rods).division.x, 50);
}

TEST_F(AutomaticDivision, StaysCoarseOnlyWhereTheFloorIsLargeNotTheCrowd) {
  TestScene<float> scene = scattered(chance_, 10'000, 0.02);
  const auto side = [&] { return voxel_size(automatic_layout(scene)).x; };
  const double without = side();
  scene.triangles.push_back(triangle_of<float>({-20, -20, -1}, {20, -20, -1}, {0, 20, -1}));
  // The voxels grow, for there are more of them to cross; but not as the floor does, forty times.
  EXPECT_LT(side(), without * 12);
}

// However many large primitives lie on each other, and so on any machine.
TEST_F(AutomaticDivisions, MakeABoundedNumberOfReferences) {
  for (const std::size_t count : {1000U, 30'000U, 300'000U}) {
    for (const double spread : {0.0, 1e-6, 1.0}) { // coincident, or nearly so, or anywhere
      for (int shape = 0; shape < 3; ++shape) {    // flat triangles, any triangles, spheres
        TestScene<float> scene;
        const Vec3d a = chance_.in_cube(1), b = chance_.in_cube(1), c = chance_.in_cube(1);
        const auto near = [&](Vec3d p) {
          if (shape == 0) p.z = 0;
          return cast<float>(p + chance_.in_cube(1) * spread);
        };
        for (std::size_t i = 0; i < count; ++i) {
          if (shape < 2)
            scene.triangles.push_back(triangle_of(near(a), near(b), near(c)));
          else
            scene.spheres.push_back(sphere_of<float>(cast<double>(near(a)), 0.5));
        }
        const DivisionStatistics statistics = division_statistics(scene.view());
        for (const RuleKind kind : {RuleKind::automatic, RuleKind::nested}) {
          DivisionRule rule;
          rule.kind = kind;
          const GridLayout layout =
              make_grid_layout<float>(scene.bounds(), SpaceRule::tight, rule, statistics);
          const double most = kind == RuleKind::nested ? 16 : 128;
          EXPECT_LE(expected_references(statistics.all, layout), 0x1p16 + most * static_cast<double>(count))
              << count << " of shape " << shape << " spread by " << spread;
        }
      }
    }
  }
}

} // namespace
} // namespace masu
