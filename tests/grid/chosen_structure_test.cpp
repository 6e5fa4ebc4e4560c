// The choice among structures by tracing some rays through each; and builds that their progress ends, at any
// time.
#include "libgrid/structure/chosen_structure.h"
#include "libgrid/structure/sampled_costs.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/base/stopwatch.h"
#include "tests/random_meshes.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace masu {
namespace {

template <class Stored>
Structure built(TestScene<Stored>& scene, StructureKind kind, Processor processor = Processor::gpu) {
  BuildOptions options;
  options.structure.kind = kind;
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

TYPED_TEST(Fastest, NoCandidateOfItsKindIsExpectedToBeClearlyFaster) {
  for (std::int64_t i = cases(50); i > 0; --i) {
    TestScene<TypeParam> scene =
        SceneMaker<TypeParam>(this->chance_, this->chance_.power_of_two(-10, 20)).scene();
    for (const Processor processor : {Processor::gpu, Processor::cpu}) {
      const auto time_of = [&](const Structure& grid) {
        return expected_time(sampled_costs(scene.view(), grid), grid.kind, processor);
      };
      constexpr double clearly = 0.95;
      const Structure fastest = built(scene, StructureKind::fastest, processor),
                      hierarchy = built(scene, StructureKind::hierarchy, processor);
      const double automatic = time_of(built(scene, StructureKind::automatic, processor));
      EXPECT_LE(clearly * automatic, time_of(built(scene, StructureKind::irregular, processor)));
      EXPECT_LE(clearly * time_of(fastest), time_of(hierarchy));
      if (grid_may_win(sampled_costs(scene.view(), hierarchy, {rays_that_tell}))) {
        EXPECT_LE(clearly * time_of(fastest), automatic);
      } else {
        expect_same(fastest, hierarchy);
      }
    }
  }
}

TYPED_TEST(Fastest, IsAGridWhereBoxesOverlapAndAHierarchyWhereSpaceIsEmpty) {
  TestScene<TypeParam> overlapping = needles<TypeParam>(this->chance_),
                       sparse = clusters<TypeParam>(this->chance_);
  EXPECT_NE(built(overlapping, StructureKind::fastest).kind, StructureKind::hierarchy);
  EXPECT_EQ(built(sparse, StructureKind::fastest).kind, StructureKind::hierarchy);
}

TYPED_TEST(Fastest, IsTheSameForAnyNumberOfThreads) {
  TestScene<TypeParam> scene = clusters<TypeParam>(this->chance_);
  for (const StructureKind kind :
       {StructureKind::uniform, StructureKind::automatic, StructureKind::fastest}) {
    compare_threads([&] { return built(scene, kind); }, expect_same);
  }
}

TYPED_TEST(Fastest, CostsAreTheSameForAnyNumberOfThreads) {
  TestScene<TypeParam> scene = clusters<TypeParam>(this->chance_);
  for (const StructureKind kind :
       {StructureKind::uniform, StructureKind::irregular, StructureKind::hierarchy}) {
    const Structure grid = built(scene, kind);
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
  EXPECT_EQ(built(scene, StructureKind::fastest).kind, StructureKind::uniform);
}

// --- What an automatic choice may take -------------------------------------------------------------------

// The CPU's, and the bytes of the largest structure that it has built, and how many it has.
class Watched final : public StructureBuilder<float> {
public:
  explicit Watched(const SceneView<float>& scene) : StructureBuilder(scene), builder_(cpu_builder(scene)) {}
  Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) override {
    Structure grid = builder_->try_build(layout, overlap, options);
    largest = std::max(largest, 4 * grid.voxel_map.size() + 4 * grid.references.size() +
                                    sizeof(MergedCell) * grid.cells.size() +
                                    sizeof(HierarchyNode) * grid.nodes.size());
    fragments = std::max(fragments, options.kind == StructureKind::irregular ? options.max_fragments : 0);
    return grid;
  }

  std::size_t largest = 0;
  std::uint64_t fragments = 0;

private:
  std::unique_ptr<StructureBuilder<float>> builder_;
};

// What lies on each other, or crosses in one place, or is larger than the rest, or lies far from zero, so
// that lists don't get shorter where they are divided; and a strip that is longer than an axis has voxels.
std::vector<std::pair<const char*, TestScene<float>>> hard_scenes(Chance& chance) {
  std::vector<std::pair<const char*, TestScene<float>>> scenes;
  const auto add = [&](const char* name, int count, const auto& make) {
    TestScene<float> scene;
    for (int i = 0; i < count; ++i)
      make(scene, i);
    scenes.emplace_back(name, std::move(scene));
  };
  const auto triangle = [](TestScene<float>& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    scene.triangles.push_back(triangle_of<float>(a, b, c));
  };
  const auto around = [](double turn) { return Vec3d{std::cos(turn), std::sin(turn), 0}; };
  add("ribbon", 150'000, [&](auto& scene, int i) {
    const double x = i;
    triangle(scene, {x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0});
  });
  add("needles in a plane", 400, [&](auto& scene, int) {
    Vec3d at = chance.in_cube(1), along = around(chance.uniform(0, 6.28)) * 0.5;
    at.z = 0;
    triangle(scene, at - along, at + along, at + along + Vec3d{-along.y, along.x, 0} * 0.004);
  });
  add("needles in all directions", 10'000, [&](auto& scene, int) {
    const Vec3d at = chance.in_cube(1), along = chance.direction();
    triangle(scene, at - along, at + along, at + along + chance.in_cube(0.0005));
  });
  add("fan", 2000, [&](auto& scene, int i) {
    triangle(scene, {0, 0, 0}, around(i * 0.00314), around((i + 1) * 0.00314));
  });
  add("equal triangles", 20'000, [&](auto& scene, int) {
    triangle(scene, {0, 0, 0}, {1, 0, 0.1}, {0, 1, 0.3});
  });
  add("nested triangles", 200, [&](auto& scene, int i) {
    const double size = std::exp2(-0.1 * i);
    triangle(scene, {0, 0, 0}, {size, 0, 0}, {0, size, 0});
  });
  add("few large through many small", 20'000, [&](auto& scene, int i) {
    const Vec3d at = i < 10 ? Vec3d{} : chance.in_cube(0.01);
    const double size = i < 10 ? 10 : 0.0005;
    triangle(scene, at + chance.in_cube(size), at + chance.in_cube(size), at + chance.in_cube(size));
  });
  add("far from zero", 300, [&](auto& scene, int i) {
    const Vec3d at = Vec3d{762, 0, 0} + Vec3d{i % 2 == 0 ? 0.0 : 5.0, 0, 0} + chance.in_cube(0.01);
    triangle(scene, at + chance.in_cube(0.001), at + chance.in_cube(0.001), at + chance.in_cube(0.001));
  });
  add("equal cones", 5000, [&](auto& scene, int) {
    scene.cones.push_back(cone_of<float>({0, 0, 0}, 1, {0.3F, 0.5F, 2}, 0.5F));
  });
  return scenes;
}

class Choices : public RandomTest, public testing::WithParamInterface<StructureKind> {};

TEST_P(Choices, TakeNoMoreThanAHierarchyEightTimes) {
  for (auto& [name, scene] : hard_scenes(chance_)) {
    SCOPED_TRACE(name);
    const SceneView<float> view = scene.view();
    const std::size_t count = view.primitive_count();
    Watched builder(view);
    BuildOptions options;
    options.structure.kind = GetParam();
    const DescribedStructure built = build_chosen(builder, {scene.bounds(), Hash{1, 2}}, options);
    EXPECT_EQ(built.grid.exceeded, nullptr);
    // While it is built a hierarchy takes 300 bytes per primitive; a grid's map and its lists are limited to
    // eight times that each. Maps with a word for each voxel are small, or were asked for.
    const bool asked = GetParam() == StructureKind::x || GetParam() == StructureKind::balance;
    EXPECT_LE(builder.largest, (std::size_t{1} << (asked ? 28 : 25)) + 2 * 8 * 300 * count);
    EXPECT_LE(builder.fragments, (std::uint64_t{1} << 16) + 128 * count);
    for (const Considered& considered : built.considered)
      EXPECT_LE(considered.costs.work, (std::uint64_t{1} << 24) + 500 * count);
  }
}
INSTANTIATE_TEST_SUITE_P(OfAllKinds, Choices,
                         testing::Values(StructureKind::fastest, StructureKind::automatic,
                                         StructureKind::uniform, StructureKind::x, StructureKind::balance,
                                         StructureKind::irregular));

// A hierarchy of what lies on each other is as slow as anything: its rays are few.
TYPED_TEST(Fastest, SamplesFewRaysWhereEachTakesLong) {
  TestScene<TypeParam> scene;
  scene.triangles.assign(20'000, triangle_of<TypeParam>({0, 0, 0}, {1, 0, 0.1F}, {0, 1, 0.3F}));
  const Structure hierarchy = built(scene, StructureKind::hierarchy);
  const SampledCosts all = sampled_costs(scene.view(), hierarchy, {64}),
                     some = sampled_costs(scene.view(), hierarchy, {2048, all.work});
  EXPECT_EQ(all.rays, 64U);
  EXPECT_EQ(some.rays, 128U);
  EXPECT_EQ(sampled_costs(scene.view(), hierarchy, {64, 0}).rays, 16U);
}

TEST(FastestAnywhere, IsAGridWhereNoHierarchyReaches) {
  TestScene<double> scene;
  for (const double at : {-1e20, 1e20})
    scene.spheres.push_back(sphere_of<double>({at, at, at}, 1e18));
  EXPECT_NE(built(scene, StructureKind::fastest).kind, StructureKind::hierarchy);
}

TEST(FastestAnywhere, IsAGridWhereAMergeRuleOrADivisionIsGiven) {
  const auto kind = [](StructureChoice structure, StructureKind merge, const char* division,
                       HierarchyQuality quality = HierarchyQuality::high) {
    return kind_of(structure, merge, parse_division(division), quality);
  };
  EXPECT_EQ(kind(StructureChoice::fastest, StructureKind::automatic, "auto"), StructureKind::fastest);
  EXPECT_EQ(kind(StructureChoice::fastest, StructureKind::automatic, "auto", HierarchyQuality::fast),
            StructureKind::fastest);
  for (const StructureChoice structure :
       {StructureChoice::fastest, StructureChoice::automatic, StructureChoice::grid}) {
    EXPECT_EQ(kind(structure, StructureKind::automatic, "woo:2"), StructureKind::automatic);
    EXPECT_EQ(kind(structure, StructureKind::x, "auto"), StructureKind::x);
    EXPECT_THROW(kind(structure, StructureKind::x, "auto", HierarchyQuality::fast), Error);
  }
  EXPECT_EQ(kind(StructureChoice::automatic, StructureKind::automatic, "auto"), StructureKind::hierarchy);
  EXPECT_EQ(kind(StructureChoice::grid, StructureKind::automatic, "auto"), StructureKind::automatic);
  EXPECT_EQ(kind(StructureChoice::hierarchy, StructureKind::automatic, "8"), StructureKind::hierarchy);
  EXPECT_THROW(kind(StructureChoice::hierarchy, StructureKind::x, "auto"), Error);
}

using HierarchyOfMeshesInMemory = RandomTest;

TEST_F(HierarchyOfMeshesInMemory, IsThatOfTheirTrianglesWrittenOut) {
  for (std::int64_t i = cases(60); i > 0; --i) {
    const std::vector<MeshArrays> meshes = random_meshes(chance_, chance_.one_of({3, 300, 10'000}));
    const Store store = chance_.one_of({Store::automatic, Store::float32, Store::float64});
    const SphereArray beside{static_cast<std::size_t>(chance_.whole(0, 20)), [](std::size_t k) {
                               return Sphere<double>{{0.1 * static_cast<double>(k), 0, 0}, 0.3};
                             }};
    const ArrayScene scene = scene_of(views_of(meshes), {{beside}});
    Scene expected_scene = written_out(meshes, scene);
    expected_scene.spheres = scene.spheres;
    expected_scene.sphere_surfaces = scene.sphere_surfaces;
    BuildOptions options = fast_hierarchy_options();
    options.structure.quality = chance_.one_of({HierarchyQuality::fast, HierarchyQuality::high});
    const SceneFile file = scene_in_memory(scene, store);
    ASSERT_EQ(file.unmade_triangles() != nullptr, scene.triangles.size() > 0);
    const StructureFile expected = built_in_memory(
        scene_in_memory(expected_scene, file.is_float64() ? Store::float64 : Store::float32), options);
    ASSERT_EQ(built_in_memory(file, options).hash(), expected.hash());
    ASSERT_EQ(file.unmade_triangles(), nullptr);
    ASSERT_EQ(built_in_memory(file, options).hash(), expected.hash()) << "of triangles that are made";
  }
}

// --- Builds that are ended -------------------------------------------------------------------------------

struct Ended {};

template <class Stored>
class EndedBuild : public RandomTest {
protected:
  EndedBuild() { add_triangles(scene_, chance_, 4000, 0.05); }
  Structure built(const BuildOptions& options, const std::function<void(double)>& progress) {
    return build_chosen(*cpu_builder(scene_.view(), progress), {scene_.bounds(), Hash{1, 2}}, options).grid;
  }
  std::vector<BuildOptions> all_options() const {
    std::vector<BuildOptions> all;
    for (const StructureKind kind :
         {StructureKind::uniform, StructureKind::x, StructureKind::balance, StructureKind::irregular,
          StructureKind::hierarchy, StructureKind::automatic, StructureKind::fastest})
      all.emplace_back().structure.kind = kind;
    all.push_back(fast_hierarchy_options());
    return all;
  }

  TestScene<Stored> scene_;
};
TYPED_TEST_SUITE(EndedBuild, Reals);

TYPED_TEST(EndedBuild, ThrowsWhatItsProgressThrowsAndTheNextIsAsEver) {
  for (const BuildOptions& options : this->all_options()) {
    SCOPED_TRACE(static_cast<int>(options.structure.kind));
    std::atomic<int> reports = 0;
    std::atomic<bool> in_range = true;
    const Structure expected = this->built(options, {});
    expect_same(expected, this->built(options, [&](double done) {
      ++reports;
      if (!(done >= 0 && done <= 1)) in_range = false;
    }));
    EXPECT_TRUE(in_range);
    EXPECT_GT(reports, 20);
    for (int i = 0; i < 8; ++i) {
      std::atomic<int> left = this->chance_.whole(1, reports / 2); // with threads there may be some less
      const auto end = [&](double) {
        if (--left <= 0) throw Ended();
      };
      EXPECT_THROW(static_cast<void>(this->built(options, end)), Ended);
    }
    expect_same(expected, this->built(options, {}));
  }
}

TEST(ParallelWork, ThrowsWherePartOfItIsLeftOut) {
  const auto done_of = [](std::size_t tasks) {
    std::atomic<int> done = 0;
    parallel_for(tasks, [&](std::size_t) { ++done; });
    return done.load();
  };
  EXPECT_EQ(done_of(1000), 1000);
  tbb::task_group_context outer;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        EXPECT_EQ(done_of(1000), 1000);
        outer.cancel_group_execution();
        EXPECT_THROW(static_cast<void>(done_of(1000)), Error);
      },
      outer);
}

// So many that threads share nodes, too: what one has ended must not be gone on with by another.
TYPED_TEST(EndedBuild, OfAHierarchyOfManyTrianglesEndsAtAnyMoment) {
  add_triangles(this->scene_, this->chance_, 250'000, 0.05);
  const std::thread::id caller = std::this_thread::get_id(); // the others learn of it from TBB alone
  for (const HierarchyQuality quality : {HierarchyQuality::fast, HierarchyQuality::high}) {
    BuildOptions options;
    options.structure = {StructureKind::hierarchy};
    options.structure.quality = quality;
    const Stopwatch watch;
    const Structure expected = this->built(options, {});
    const double whole = watch.seconds();
    int ended = 0;
    for (std::int64_t i = cases(5); i > 0; --i) {
      const double end = watch.seconds() + (ended > 0 ? this->chance_.uniform(0, whole) : 0);
      try {
        this->built(options, [&](double) {
          if (std::this_thread::get_id() == caller && watch.seconds() > end) throw Ended();
        });
      } catch (const Ended&) {
        ++ended;
      }
    }
    EXPECT_GT(ended, 0);
    expect_same(expected, this->built(options, {}));
  }
}

TYPED_TEST(EndedBuild, SharesOfWhatIsDoneRise) {
  for (const BuildOptions& options : this->all_options()) {
    SCOPED_TRACE(static_cast<int>(options.structure.kind));
    made_by_threads(1, [&] {
      double last = 0;
      this->built(options, [&](double done) {
        EXPECT_GE(done, last);
        last = done;
      });
      return last;
    });
  }
}

} // namespace
} // namespace masu
