// What lets a hierarchy's results be those of trying every primitive (walk_test.cpp): boxes contain what they
// hold, on every way of computing them, and are found to be met.
#include "libgrid/hierarchy/binary/large_leaves.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libgrid/hierarchy/node_boxes.h"
#include "libgrid/statistics/statistics.h"
#include "libgrid/trace/trace.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/refused.h"
#include "tests/same_grid.h"
#include "tests/surface_point.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace masu {
namespace {

Boxd common(const Boxd& a, const Boxd& b) {
  Boxd box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min.set(axis, std::max(a.min[axis], b.min[axis]));
    box.max.set(axis, std::min(a.max[axis], b.max[axis]));
  }
  return box;
}

// Of each primitive, for each reference to it, what is common to all boxes on the way to it.
std::vector<std::vector<Boxd>> boxes_of_primitives(const Structure& grid, std::uint32_t primitives) {
  std::vector<std::vector<Boxd>> boxes(primitives);
  constexpr Boxd everywhere{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  const std::function<void(std::uint32_t, const Boxd&)> descend = [&](std::uint32_t number,
                                                                      const Boxd& around) {
    const HierarchyNode& node = grid.nodes[number];
    std::uint32_t next = node.first_node;
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t held = slot_byte(node.slots, slot);
      const Boxd box = common(around, box_of(node, slot));
      if ((node_slots(node) >> slot & 1) != 0) {
        descend(next++, box);
        continue;
      }
      for (std::uint32_t i = 0; i < references_in(held); ++i)
        boxes.at(grid.references.at(node.first_reference + references_begin(held) + i)).push_back(box);
    }
  };
  descend(0, everywhere);
  return boxes;
}

using Hierarchies = RandomTest;
template <class Stored>
class BuiltHierarchy : public RandomTest {};
TYPED_TEST_SUITE(BuiltHierarchy, Reals);

// The walk is proven for hits up to 89 u M off their surface; the rest of the margin is for the walk itself.
TYPED_TEST(BuiltHierarchy, HoldsEveryPartOfEveryPrimitiveWithItsMargin) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(500); s > 0 && !this->HasFailure(); --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    const Structure grid = hierarchy_of(scene, any_quality(chance));
    const SceneView<Stored> view = scene.view();
    const auto boxes = boxes_of_primitives(grid, scene.count());
    const double unsure = 1e-12 * largest_magnitude(scene.bounds()); // rounding of this test's own points
    for (PrimitiveIndex i = 0; i < scene.count(); ++i) {
      with_primitive(view, i, [&](const auto& primitive) {
        ASSERT_EQ(boxes[i].empty(), !has_surface(primitive)) << "primitive " << i << '\n' << described(scene);
        if (boxes[i].empty()) return;
        for (int k = 0; k < 20; ++k) {
          const Vec3d at = on_surface(chance, widened(primitive)).at,
                      near = chance.in_cube(grid.layout.margin * 0.999);
          const Vec3d point = at + near;
          ASSERT_TRUE(std::ranges::any_of(
              boxes[i], [&](const Boxd& box) { return contains(grown(box, unsure), point); }))
              << described(primitive) << ": " << described(point) << '\n'
              << described(scene);
        }
      });
    }
  }
}

std::vector<std::uint32_t> parts_of_primitives(const Structure& hierarchy, std::size_t count) {
  std::vector<std::uint32_t> parts(count, 0);
  for (const PrimitiveIndex reference : hierarchy.references)
    ++parts.at(reference);
  return parts;
}

TYPED_TEST(BuiltHierarchy, OfFastQualityDividesLongSlantedTriangles) {
  Chance& chance = this->chance_;
  TestScene<TypeParam> scene;
  const auto add = [&](const Vec3d& at, const Vec3d& along, const Vec3d& across) {
    scene.triangles.push_back(triangle_of<TypeParam>(at, at + along, at + across));
  };
  for (int i = 0; i < 2000; ++i)
    add(chance.in_cube(1), chance.in_cube(0.01), chance.in_cube(0.01));
  for (int i = 0; i < 10; ++i)
    add(chance.in_cube(1), {0.7, 0.6, 0.5}, chance.in_cube(0.01));
  const auto parts = parts_of_primitives(hierarchy_of(scene, HierarchyQuality::fast), scene.count());
  for (PrimitiveIndex i = 2000; i < scene.count(); ++i)
    EXPECT_GT(parts[i], 1) << i;
}

// Along two axes each: none is worth dividing for its empty box.
TYPED_TEST(BuiltHierarchy, OfFastQualityDividesWhatIsLargeAmongOthersWithinItsBounds) {
  Chance& chance = this->chance_;
  TestScene<TypeParam> scene;
  std::vector<double> widths;
  double sum = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d at = chance.in_cube(1);
    const double size = chance.power_of_two(-9, 0);
    const auto axis = static_cast<int>(chance.index(3));
    Vec3d along{}, across{};
    along.set(axis, size);
    across.set((axis + 1) % 3, size);
    scene.triangles.push_back(triangle_of<TypeParam>(at, at + along, at + across));
    widths.push_back(size);
    sum += size;
  }
  const Structure hierarchy = hierarchy_of(scene, HierarchyQuality::fast);
  const auto parts = parts_of_primitives(hierarchy, widths.size());
  const double least = large_width * 0.99 * sum / static_cast<double>(widths.size());
  for (std::size_t i = 0; i < widths.size(); ++i)
    EXPECT_TRUE(parts[i] == 1 || widths[i] > least) << i;
  EXPECT_GT(hierarchy.references.size(), 1.1 * scene.count());
  EXPECT_LE(hierarchy.references.size(), (1 + spare_parts) * scene.count());
}

TEST_F(Hierarchies, PartsOfAPrimitiveThatLieSideBySideAreOne) {
  for (std::int64_t i = cases(1000); i > 0; --i) {
    const auto length = [&] { return static_cast<float>(chance_.uniform(0.1, 10)); };
    // Flat along an axis, beside each other along another one; or in a line through space.
    const Vec3f corner = cast<float>(chance_.in_cube(10));
    Vec3f to_middle{length(), length(), length()}, across{};
    const auto axis = static_cast<int>(chance_.index(3)), along = (axis + 1) % 3;
    to_middle.set(axis, 0.01F);
    across.set(along, to_middle[along]);
    const BinaryNode a{corner, 7, corner + to_middle, 1}, beside{corner + across, 7, a.max + across, 1},
        above{a.max, 7, a.max + to_middle, 1}, other{beside.min, 8, beside.max, 1};
    const auto node = [&](const BinaryNode& b) { return node_of(join(a.box(), b.box()), 40, a, b); };
    EXPECT_EQ(node(beside).count, 1U);
    EXPECT_EQ(node(beside).index, 7U);
    EXPECT_EQ(node(above).count, 2U);
    EXPECT_EQ(node(other).count, 2U);
    EXPECT_EQ(node(other).index, 40U);
  }
}

void write_hierarchy(const Structure& grid, std::uint64_t primitives, const std::string& path) {
  write_structure(grid, {{1, 2}, primitives, {0, 0, 0}, SpaceRule::tight, Overlap::exact, "auto"}, path);
}

TYPED_TEST(BuiltHierarchy, CanBeWrittenAndOpenedAndItsStatisticsCountWhatIsThere) {
  Chance& chance = this->chance_;
  const TemporaryFolder folder;
  const std::string path = folder.file("a.grid");
  for (std::int64_t s = cases(100); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Structure grid = hierarchy_of(scene, any_quality(chance));
    write_hierarchy(grid, scene.count(), path);
    const StructureFile file(path);
    ASSERT_TRUE(file.is_hierarchy());
    EXPECT_FALSE(file.is_merged());
    EXPECT_TRUE(same_values(file.references(), grid.references));
    EXPECT_TRUE(same_values(file.nodes(), grid.nodes));
    const HierarchyStatistics counted = hierarchy_statistics(grid.nodes);
    EXPECT_EQ(counted.nodes, grid.nodes.size());
    EXPECT_EQ(counted.node_boxes + 1, counted.nodes); // all but the root are in a box
    EXPECT_EQ(counted.references, grid.references.size());
    EXPECT_GE(counted.reference_boxes * max_references_per_box, counted.references);
    EXPECT_LE(counted.boxes_per_node, boxes_per_node);
    EXPECT_TRUE(std::isfinite(counted.nodes_per_ray) && counted.nodes_per_ray >= 1);
    EXPECT_TRUE(std::isfinite(counted.tests_per_ray) && counted.tests_per_ray > 0);
  }
}

// Each is split off alone: as deep as the walk's stack allows, and no deeper.
TYPED_TEST(BuiltHierarchy, IsNeverTooDeepForTheWalk) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.grid");
  for (const double ratio : {1.5, 2.0, 8.0, 40.0, 1e4}) {
    for (const int copies : {1, 4, 100}) {
      for (const double largest : {1.0, 1e12, 1e-9}) {
        TestScene<TypeParam> scene;
        const double least = std::is_same_v<TypeParam, float> ? 1e-37 : 1e-300;
        for (double at = largest; at > least && scene.count() < 30'000; at /= ratio)
          for (int i = 0; i < copies; ++i)
            scene.spheres.push_back(sphere_of<TypeParam>({at, at, at}, at / 64));
        SCOPED_TRACE(testing::Message() << ratio << ", " << copies << " copies from " << largest);
        for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
          const Structure grid = hierarchy_of(scene, quality);
          EXPECT_LE(hierarchy_statistics(grid.nodes).depth, max_hierarchy_depth);
          EXPECT_EQ(grid.references.size(), scene.count());
          write_hierarchy(grid, scene.count(), path);
          EXPECT_NO_THROW(const StructureFile file(path));
        }
      }
    }
  }
}

TYPED_TEST(BuiltHierarchy, RefittedWhereNothingMovedIsTheSameBytes) {
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(200); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Structure grid = hierarchy_of(scene, any_quality(chance));
    std::vector<PrimitiveIndex> listed(grid.references.begin(), grid.references.end());
    std::ranges::sort(listed);
    if (std::ranges::adjacent_find(listed) != listed.end()) continue; // something is divided
    Structure again = grid;
    ASSERT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), again));
    expect_same(grid, again);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

// Also what was divided, and each of whose parts was in another box.
TYPED_TEST(BuiltHierarchy, RefittedHoldsEachPrimitiveWhole) {
  Chance& chance = this->chance_;
  std::int64_t divided = 0;
  for (std::int64_t s = cases(200); s > 0 && !this->HasFailure(); --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    Structure grid = hierarchy_of(scene, any_quality(chance));
    divided += grid.references.size() > scene.count();
    const PrimitiveIndex count = scene.count();
    move_primitives(chance, scene, chance.power_of_two(-10, 1));
    // Cones of no length are gone; and what had no surface may have one now.
    if (scene.count() != count || !refit_hierarchy(scene.view(), hierarchy_layout(scene), grid)) continue;
    const auto boxes = boxes_of_primitives(grid, scene.count());
    for (PrimitiveIndex i = 0; i < scene.count(); ++i) {
      with_primitive(scene.view(), i, [&](const auto& primitive) {
        const Boxd whole = grown(bounds(primitive), grid.layout.margin * 0.999);
        EXPECT_TRUE(!has_surface(primitive) || std::ranges::any_of(boxes[i], [&](const Boxd& box) {
          return contains(box, whole.min) && contains(box, whole.max);
        })) << described(primitive);
      });
    }
    EXPECT_FALSE(this->HasFailure()) << described(scene);
  }
  EXPECT_GT(divided, 0);
}

TYPED_TEST(BuiltHierarchy, IsNotRefittedWhereAPrimitiveGetsASurface) {
  TestScene<TypeParam> scene = scattered_scene<TypeParam>(this->chance_, 100);
  const Vec3<TypeParam> a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  scene.triangles.push_back(triangle_of(a, a, a));
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    Structure grid = hierarchy_of(scene, quality);
    EXPECT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
    TestScene<TypeParam> moved = scene;
    moved.triangles.back() = triangle_of(a, b, c);
    const Structure before = grid;
    EXPECT_FALSE(refit_hierarchy(moved.view(), hierarchy_layout(moved), grid));
    expect_same(before, grid);
    grid = hierarchy_of(moved, quality); // and back: one that has lost its surface stays
    EXPECT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
  }
}

// Areas are computed in float32: they would be infinite.
TEST(Hierarchy, OfASceneThatReachesBeyondFloat32IsRefused) {
  TestScene<double> scene;
  scene.spheres.push_back(sphere_of<double>({0, 0, 0}, 0.99e15));
  EXPECT_NO_THROW(hierarchy_of(scene));
  scene.spheres.push_back(sphere_of<double>({2e15, 0, 0}, 1));
  EXPECT_TRUE(is_refused_with(ErrorCode::usage, "structure", [&] { hierarchy_of(scene); }));
}

// --- Boxes met -------------------------------------------------------------------------------------------

// Plane by plane, without vectors.
template <class Real>
MetBoxes boxes_met_one_by_one(const HierarchyNode& node, const Vec3<Real>& origin, const Vec3<Real>& inverse,
                              Real t_max) {
  MetBoxes met;
  std::vector<std::uint32_t> entries; // into nodes
  for (int slot = 0; slot < boxes_per_node; ++slot) {
    Real enter = 0, leave = t_max;
    for (int axis = 0; axis < 3; ++axis) {
      const Real scale =
          static_cast<Real>(std::ldexp(1.0F, static_cast<int>(node.exponents >> (8 * axis) & 0xff) - 127)) *
          inverse[axis];
      const Real start = std::fma(Real(-32768), scale,
                                  (static_cast<Real>(node.origin[axis]) - origin[axis]) * inverse[axis]);
      const auto t = [&](std::uint32_t plane) {
        return std::fma(static_cast<Real>(32768 + plane), scale, start);
      };
      const std::uint32_t low = slot_byte(node.low[axis], slot), high = slot_byte(node.high[axis], slot);
      enter = std::max(enter, t(inverse[axis] >= 0 ? low : high));
      leave = std::min(leave, t(inverse[axis] >= 0 ? high : low));
    }
    if (!(enter <= leave)) continue;
    const std::uint32_t held = slot_byte(node.slots, slot), number = static_cast<std::uint32_t>(slot);
    if ((held & 0x18) == 0x18) {
      met.bits |= 1U << (24 + number);
      entries.push_back((bits_of(rounded_down(static_cast<double>(enter)) + 0.0F) & ~7U) | number);
    } else {
      met.bits |= held >> 5 << references_begin(held);
    }
  }
  std::ranges::sort(entries);
  if (!entries.empty()) met.nearest = entries[0];
  if (entries.size() > 1) met.second = entries[1];
  return met;
}

// However many boxes the processor's instructions take at once: so what is visited is the same everywhere.
TYPED_TEST(BuiltHierarchy, BoxesMetAreTheSameOneByOne) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t met = 0, missed = 0;
  for (std::int64_t s = cases(500); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const Boxd bounds = scene.bounds();
    const SceneView<Real> view = scene.view();
    const Structure grid = hierarchy_of(scene, any_quality(chance));
    RayMaker<Real> rays(chance, scene, bounds, grid);
    for (int i = 0; i < 200; ++i) {
      ClippedRay<Real> near{};
      if (!clip(rays.ray(), view.clip, near)) continue;
      const Vec3<Real> inverse = bounded_inverse(near);
      for (const HierarchyNode& node : grid.nodes) {
        const MetBoxes found = boxes_met(node, near.ray.origin, inverse, near.ray.t_max),
                       expected = boxes_met_one_by_one(node, near.ray.origin, inverse, near.ray.t_max);
        ASSERT_TRUE(found.bits == expected.bits && found.nearest == expected.nearest &&
                    found.second == expected.second)
            << described(near.ray.origin, near.ray.direction) << '\n'
            << described(scene);
        (found.bits != 0 ? met : missed) += 1;
      }
    }
  }
  EXPECT_GT(met, cases(10'000));
  EXPECT_GT(missed, cases(1000));
}

TEST_F(Hierarchies, OfMorePrimitivesThanThereIsMemoryOrNumbersForAreRefused) {
  const auto refused = [](std::uint64_t primitives, double available, const char* says) {
    return is_refused_with(
        ErrorCode::usage, "structure", [&] { check_hierarchy(primitives, available); }, says);
  };
  constexpr double plenty = 1e18;
  EXPECT_NO_THROW(check_hierarchy(1000, 300000));
  EXPECT_TRUE(refused(1000, 299999, "free: build a grid"));
  EXPECT_EQ(max_hierarchy_primitives, 421'075'224U); // as gridbuild.md and many-machines.md say
  EXPECT_NO_THROW(check_hierarchy(max_hierarchy_primitives, plenty));
  EXPECT_TRUE(refused(max_hierarchy_primitives + 1, plenty, "can be numbered"));
  // With what is divided, references have 31 bits, and twice as many binary nodes 32.
  EXPECT_LE(static_cast<double>(max_hierarchy_primitives) * (1 + spare_leaves) * (1 + spare_fragments),
            0x7fffffff);
}

} // namespace
} // namespace masu
