// Grids of a builder against the CPU's, byte for byte: one text of tests for every builder there is.
#pragma once

#include "libgrid/structure/builder.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

namespace masu {

// Builder: a type Stored, of the scene's numbers; make(scene), a StructureBuilder; missing(), why there is
// none or an empty text; and many, how many primitives a large scene has.
template <class Builder>
class BuilderComparison : public RandomTest {
protected:
  using Number = typename Builder::Stored;

  void SetUp() override {
    if (const std::string why = Builder::missing(); !why.empty())
      GTEST_SKIP() << "nothing was compared: " << why;
  }
  // Of about ten primitives in random hard cases, and now and then of many.
  TestScene<Number> scene(std::int64_t number) {
    return number % 10 == 0 ? scattered_scene<Number>(chance_, Builder::many)
                            : SceneMaker<Number>(chance_, chance_.power_of_two(-10, 20)).scene();
  }
  // Returns what both build.
  Structure expect_same_builds(TestScene<Number>& scene, const GridLayout& layout, Overlap overlap,
                               const StructureOptions& options = {}) {
    Structure grid = build_structure(scene.view(), layout, overlap, options);
    expect_same(grid, Builder::make(scene.view())->build(layout, overlap, options));
    EXPECT_FALSE(this->HasFailure()) << described(grid) << '\n' << described(scene);
    return grid;
  }
  void expect_same_hierarchies(TestScene<Number>& scene) {
    StructureOptions options{StructureKind::hierarchy};
    for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
      options.quality = quality;
      expect_same_builds(scene, hierarchy_layout(scene), Overlap::exact, options);
    }
  }
};
TYPED_TEST_SUITE_P(BuilderComparison);

TYPED_TEST_P(BuilderComparison, AUniformGridIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(300); s > 0 && !this->HasFailure(); --s) {
    auto scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    this->expect_same_builds(scene, random_layout<Stored>(chance, scene.bounds()), any_overlap(chance));
  }
}

TYPED_TEST_P(BuilderComparison, AUniformGridOfBlocksIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(3); s > 0; --s) {
    auto scene = SceneMaker<Stored>(chance, 1).fine();
    GridLayout layout = random_layout<Stored>(chance, scene.bounds());
    layout.division = {chance.whole(200, 260), chance.whole(220, 250), chance.whole(220, 250)};
    EXPECT_GT(this->expect_same_builds(scene, layout, Overlap::exact).block_log2, 0);
  }
}

TYPED_TEST_P(BuilderComparison, AMergedGridIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  std::int64_t divided = 0;
  for (std::int64_t s = cases(300); s > 0 && !this->HasFailure(); --s) {
    auto scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    auto [layout, overlap, options] = random_irregular_case<Stored>(chance, scene.bounds());
    if (chance.one_in(3)) options.kind = chance.one_of({StructureKind::x, StructureKind::balance});
    const Structure grid = this->expect_same_builds(scene, layout, overlap, options);
    divided += grid.voxel_map.size() > voxel_count(layout.division) + 3;
  }
  EXPECT_GT(divided, cases(75));
}

// On the host's cores one part after another; rows of many pairs all at once.
TYPED_TEST_P(BuilderComparison, AMergedGridOfManyPartsIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(2); s > 0 && !this->HasFailure(); --s) {
    auto scene = SceneMaker<Stored>(chance, 1).fine();
    while (scene.view().primitive_count() < 100000)
      scene.triangles.insert(scene.triangles.end(), scene.triangles.begin(), scene.triangles.end());
    StructureOptions options = random_grid_options(chance);
    options.nested_log2 = std::min(options.nested_log2, 2);
    GridLayout layout = random_layout<Stored>(chance, scene.bounds());
    layout.division = {chance.whole(1, 60), chance.whole(1, 30), chance.whole(1, 30)};
    if (s == 1) layout.division = {1, 1, 1};
    this->expect_same_builds(scene, layout, Overlap::box, options);
  }
}

TYPED_TEST_P(BuilderComparison, AHierarchyIsTheSameBytes) {
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    StructureOptions options{StructureKind::hierarchy};
    options.quality = quality;
    std::int64_t divided = 0;
    for (std::int64_t s = cases(100); s > 0 && !this->HasFailure(); --s) {
      auto scene = this->scene(s);
      const Structure grid =
          this->expect_same_builds(scene, hierarchy_layout(scene), Overlap::exact, options);
      divided += grid.references.size() > scene.count();
    }
    EXPECT_GT(divided, 0);
  }
}

// Of sizes between two powers of 2.
template <class Stored>
void add_triangles(Chance& chance, TestScene<Stored>& scene, int count, int least, int most) {
  for (; count > 0; --count) {
    const Vec3d at = chance.in_cube(1);
    const double size = chance.power_of_two(least, most);
    scene.triangles.push_back(triangle_of<Stored>(at, at + chance.in_cube(size), at + chance.in_cube(size)));
  }
}

// Things in a room, small or of all sizes, which are divided where they are large, as its walls are; of parts
// that are side by side one is made again.
TYPED_TEST_P(BuilderComparison, AHierarchyOfARoomIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(10); s > 0 && !this->HasFailure(); --s) {
    TestScene<Stored> scene;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d along{}, across{};
      along.set((axis + 1) % 3, 2);
      across.set((axis + 2) % 3, 2);
      const Vec3d at{-1, -1, -1}, opposite{1, 1, 1};
      scene.triangles.push_back(triangle_of<Stored>(at, at + along, at + across));
      scene.triangles.push_back(triangle_of<Stored>(opposite, opposite - along, opposite - across));
    }
    const int size = chance.whole(-8, -4);
    add_triangles(chance, scene, chance.whole(1, chance.one_of({300, TypeParam::many})), size,
                  chance.one_in(2) ? size : 0);
    this->expect_same_hierarchies(scene);
  }
}

// So many that all cores split them, and builders give memory back meanwhile.
TYPED_TEST_P(BuilderComparison, AHierarchyOfMuchIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  TestScene<Stored> scene;
  if (chance.one_in(2))
    scene = scattered_scene<Stored>(chance, 150000);
  else
    add_triangles(chance, scene, chance.whole(1, 150000), -12, 0);
  this->expect_same_hierarchies(scene);
}

// Where what may be divided runs out, and where halves are taken: then the order of parts matters.
TYPED_TEST_P(BuilderComparison, AHierarchyOfWhatOverlapsEverywhereIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(20); s > 0 && !this->HasFailure(); --s) {
    TestScene<Stored> scene;
    const double width = chance.power_of_two(-10, 0); // of a needle
    for (int i = chance.whole(1, TypeParam::many / 4); i > 0; --i) {
      const Vec3d at = chance.in_cube(1), along = chance.in_cube(1);
      scene.triangles.push_back(triangle_of<Stored>(at - along, at + along, at + chance.in_cube(width)));
    }
    if (chance.one_in(2)) scene.triangles.resize(chance.index(scene.triangles.size()) / 16 + 1);
    if (chance.one_in(2)) repeat_primitives(scene, chance.whole(1, 12)); // coincident ones
    if (chance.one_in(4)) scene.spheres.push_back(sphere_of<Stored>({0, 0, 0}, 1));
    if (chance.one_in(4)) scene.cones.push_back(cone_of<Stored>({-1, 0, 0}, 1, {1, 1, 1}, 0.1));
    EXPECT_GE(
        this->expect_same_builds(scene, hierarchy_layout(scene), Overlap::exact, {StructureKind::hierarchy})
            .references.size(),
        scene.count());
  }
}

TYPED_TEST_P(BuilderComparison, AGridOfNothingIsTheSameBytes) {
  TestScene<typename TypeParam::Stored> scene;
  const GridLayout layout{{{-1, -1, -1}, {1, 1, 1}}, {3, 4, 5}, 0};
  for (const StructureKind kind : {StructureKind::uniform, StructureKind::x, StructureKind::balance,
                                   StructureKind::irregular, StructureKind::hierarchy})
    this->expect_same_builds(scene, layout, Overlap::exact, {kind});
}

REGISTER_TYPED_TEST_SUITE_P(BuilderComparison, AUniformGridIsTheSameBytes, AUniformGridOfBlocksIsTheSameBytes,
                            AMergedGridIsTheSameBytes, AMergedGridOfManyPartsIsTheSameBytes,
                            AHierarchyIsTheSameBytes, AHierarchyOfARoomIsTheSameBytes,
                            AHierarchyOfMuchIsTheSameBytes, AHierarchyOfWhatOverlapsEverywhereIsTheSameBytes,
                            AGridOfNothingIsTheSameBytes);

} // namespace masu
