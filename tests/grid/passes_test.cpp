// Grids built by passes as a device runs them, as plain loops, against those built by the CPU; and sorting.
#include "libgrid/hierarchy/binary/spatial_split_passes.h"
#include "libgrid/hierarchy/binary/top_down_passes.h"
#include "libgrid/hierarchy/leaf_passes.h"
#include "libgrid/hierarchy/refit_passes.h"
#include "libscene/mesh/move_passes.h"
#include "libscene/passes/host_executor.h"
#include "tests/grid/builder_comparison.h"
#include "tests/grid/device_like_executor.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>
#include <vector>

namespace masu {
namespace {

template <class Stored>
class DeviceLikeBuilder final : public StructureBuilder<Stored> {
public:
  using StructureBuilder<Stored>::StructureBuilder;
  Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) override {
    const SceneView<Stored>& scene = this->scene();
    if (options.kind == StructureKind::uniform)
      return uniform_grid(executor_, scene, layout, overlap, options.max_references, options.max_map_words);
    if (options.kind != StructureKind::hierarchy)
      return merged_grid(executor_, scene, layout, overlap, options);
    auto made = hierarchy_leaves(executor_, scene, layout);
    return collapsed_hierarchy(
        executor_, layout,
        options.quality == HierarchyQuality::fast
            ? top_down_hierarchy(executor_, std::move(made), triangles_of(scene), layout.space)
            : spatial_split_hierarchy(executor_, scene, layout.margin, std::move(made.leaves)));
  }

private:
  DeviceLikeExecutor executor_;
};

template <class Stored_>
struct DeviceLike {
  using Stored = Stored_;
  static constexpr int many = 5000;
  static auto make(const SceneView<Stored>& scene) {
    return std::make_unique<DeviceLikeBuilder<Stored>>(scene);
  }
  static std::string missing() { return ""; }
};
using DeviceLikes = testing::Types<DeviceLike<float>, DeviceLike<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(ByPasses, BuilderComparison, DeviceLikes);

template <class Stored>
class RefittedHierarchy : public RandomTest {};
TYPED_TEST_SUITE(RefittedHierarchy, Reals);

TYPED_TEST(RefittedHierarchy, IsTheSameBytesByAnyExecutor) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  for (std::int64_t s = cases(30); s > 0 && !this->HasFailure(); --s) {
    auto scene = scattered_scene<TypeParam>(chance, 1000);
    Structure grid = hierarchy_of(scene, any_quality(chance)), other = grid;
    move_primitives(chance, scene, chance.power_of_two(-10, 1));
    const GridLayout layout = hierarchy_layout(scene);
    EXPECT_TRUE(refit_hierarchy(scene.view(), layout, grid));
    EXPECT_TRUE(holds_all(executor, scene.view(), other.references));
    refit(executor, scene.view(), layout.margin, other.nodes, other.references.data(),
          other.references.size());
    other.layout = layout;
    expect_same(grid, other);
    EXPECT_FALSE(this->HasFailure()) << described(scene);
  }
}

using Executors = RandomTest;
template <class Stored>
class MovedTriangles : public RandomTest {};
TYPED_TEST_SUITE(MovedTriangles, Reals);

TYPED_TEST(MovedTriangles, AreTheSameByAnyExecutor) {
  Chance& chance = this->chance_;
  DeviceLikeExecutor executor;
  TbbExecutor host;
  for (std::int64_t s = cases(100); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const std::size_t count = scene.triangles.size();
    std::vector<double> vertices(9 * count);
    for (double& v : vertices)
      v = chance.one_in(20) ? vertices.front() : chance.uniform(-1, 1);
    std::vector<std::uint32_t> indices(3 * count);
    for (std::uint32_t& index : indices)
      index = static_cast<std::uint32_t>(chance.index(3 * count));
    const WorldVertices<double> moved{vertices.data(), chance.one_in(2) ? indices.data() : nullptr,
                                      chance.one_in(2) ? Vec3d{} : chance.in_cube(1)};
    const auto here = moved_triangles(host, scene.view(), moved, nullptr, 0, max_hierarchy_reach);
    const auto there = moved_triangles(executor, scene.view(), moved, nullptr, 0, max_hierarchy_reach);
    EXPECT_EQ(here.bounds.min, there.bounds.min);
    EXPECT_EQ(here.bounds.max, there.bounds.max);
    ASSERT_TRUE(same_values(here.triangles, there.triangles));
    for (const auto& triangle : here.triangles)
      for (const auto& corner : {triangle.a, triangle.b, triangle.c})
        ASSERT_TRUE(contains(here.bounds, cast<double>(corner)));
    // All but the last are referred to.
    std::vector<PrimitiveIndex> listed(count + 1);
    std::iota(listed.begin(), listed.end(), PrimitiveIndex{0});
    EXPECT_FALSE(
        moved_triangles(executor, scene.view(), moved, listed.data(), count, max_hierarchy_reach).is_missing);
    if (count == 0) continue;
    // In leaf order, some twice, with another primitive, and with what follows the leaves.
    listed.pop_back();
    for (std::size_t i = 0; i < scene.view().primitive_count(); i += 3)
      listed.push_back(static_cast<PrimitiveIndex>(i));
    std::vector<Triangle<TypeParam>> leaves(listed.size() + 1), expected = leaves;
    std::vector<TrianglePlace> places(count);
    for (std::size_t i = 0; i < listed.size(); ++i) {
      const PrimitiveIndex number = listed[i];
      if (number < count) {
        places[number] = {static_cast<std::uint32_t>(i), 0};
        leaves[i] = scene.triangles[number];
        expected[i] = here.triangles[number];
      }
      leaves[i].object = expected[i].object = number;
    }
    SceneView<TypeParam> in_leaf_order = scene.view();
    in_leaf_order.triangles = leaves.data();
    in_leaf_order.places = places.data();
    EXPECT_TRUE(same_values(
        moved_triangles(executor, in_leaf_order, moved, listed.data(), listed.size(), max_hierarchy_reach)
            .triangles,
        expected));
    const SceneTriangle last = moved.face(count - 1);
    EXPECT_EQ(moved_triangles(executor, scene.view(), moved, listed.data(), count - 1, max_hierarchy_reach)
                  .is_missing,
              has_distinct_corners(last.a, last.b, last.c));
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
