// Grids built on the GPU against the CPU's, byte for byte. Skipped, and said so, where there is no CUDA
// device.
#include "libgrid/structure/chosen_structure.h"
#include "libscene/cuda/cuda_device.h"
#include "renderer/tracer/tracer.h"
#include "tests/grid/builder_comparison.h"
#include "tests/random_meshes.h"

namespace masu {
namespace {

template <class Stored_>
struct Gpu {
  using Stored = Stored_;
  static constexpr int many = 30'000;
  static auto make(const SceneView<Stored>& scene) { return cuda_builder(scene); }
  static std::string missing() {
    std::string why;
    return cuda_available(why) ? "" : "no GPU: " + why;
  }
};
using Gpus = testing::Types<Gpu<float>, Gpu<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(OnTheGpu, BuilderComparison, Gpus);

template <class Builder>
class BuiltOnTheGpu : public BuilderComparison<Builder> {};
TYPED_TEST_SUITE(BuiltOnTheGpu, Gpus);

// Nodes of so many fragments that many blocks of threads share one.
TYPED_TEST(BuiltOnTheGpu, AHierarchyOfManyTrianglesIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  TestScene<Stored> scene;
  add_triangles(scene, chance, 300'000, 0.02, 0.1);
  add_triangles(scene, chance, 300, 1);
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    StructureOptions options{StructureKind::hierarchy};
    options.quality = quality;
    this->expect_same_builds(scene, hierarchy_layout(scene), Overlap::exact, options);
  }
}

// Boxes of so many parts that a block of threads divides them, and not a warp.
TYPED_TEST(BuiltOnTheGpu, AnIrregularGridOfCrowdedVoxelsIsTheSameBytes) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  TestScene<Stored> scene;
  for (int i = 0; i < 30'000; ++i) {
    const Vec3d at = chance.in_cube(1) * (chance.one_in(2) ? 0.1 : 1.0);
    const auto near = [&] { return cast<Stored>(at + chance.in_cube(0.02)); };
    scene.triangles.push_back(triangle_of(near(), near(), near()));
    if (i % 10 == 0) scene.spheres.push_back(sphere_of<Stored>(at, 0.01));
    if (i % 10 == 1) scene.cones.push_back(cone_of<Stored>(at, 0.01, at + chance.direction() * 0.02, 0.005));
  }
  StructureOptions options{StructureKind::irregular};
  for (const Vec3i& division : {Vec3i{1, 1, 1}, Vec3i{3, 2, 1}, Vec3i{20, 20, 20}}) {
    GridLayout layout = random_layout<Stored>(chance, scene.bounds());
    layout.division = division;
    for (const Overlap overlap : {Overlap::exact, Overlap::box}) {
      this->expect_same_builds(scene, layout, overlap);
      this->expect_same_builds(scene, layout, overlap, options);
    }
  }
}

using HierarchyOfMeshes = RandomTest;

// The host's are made later, by who asks for the hash.
TEST_F(HierarchyOfMeshes, IsTheCpusWhereTheGpuMakesTheTriangles) {
  if (std::string why; !cuda_available(why)) GTEST_SKIP() << "no GPU: " << why;
  for (std::int64_t i = cases(100); i > 0; --i) {
    const ArrayScene scene = scene_of(views_of(random_meshes(chance_, chance_.one_of({3, 300, 30'000}))));
    const SceneFile file =
        scene_in_memory(scene, chance_.one_of({Store::automatic, Store::float32, Store::float64}));
    const ResidentTracer tracer = ResidentTracer::by_fast_hierarchy(file, {0}, {});
    ASSERT_EQ(file.unmade_triangles() != nullptr, file.primitive_count() > 0);
    const StructureFile built = tracer.built_hierarchy();
    ASSERT_EQ(built.hash(), built_in_memory(file, fast_hierarchy_options(), {}).hash());
  }
}

} // namespace
} // namespace masu
