// Results are independent of the hierarchy: through it a ray finds the same bits as by trying every
// primitive. And what is behind that: boxes contain what they hold, on every way of computing them, and walks
// end.
#include "libgrid/build/hierarchy.h"
#include "libgrid/build/passes/node_boxes.h"
#include "libgrid/statistics/hierarchy_statistics.h"
#include "libscene/base/error.h"
#include "tests/grid/walk_comparison.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/same_grid.h"
#include "tests/surface_point.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <functional>
#include <numbers>

namespace masu {
namespace {

// A box in a node, as tracing sees it: exact, since a unit is no finer than the origin's last digit.
Boxd decoded_box(const HierarchyNode& node, int slot) {
  Boxd box;
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = std::ldexp(1.0, static_cast<int>(node.exponents >> (8 * axis) & 0xff) - 127);
    box.min.set(axis, node.origin[axis] + unit * slot_byte(node.low[axis], slot));
    box.max.set(axis, node.origin[axis] + unit * slot_byte(node.high[axis], slot));
  }
  return box;
}

Boxd common(const Boxd& a, const Boxd& b) {
  Boxd box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min.set(axis, std::max(a.min[axis], b.min[axis]));
    box.max.set(axis, std::min(a.max[axis], b.max[axis]));
  }
  return box;
}

// Of each primitive, for each reference to it, what is common to all boxes on the way to it.
std::vector<std::vector<Boxd>> boxes_of_primitives(const Grid& grid, std::uint32_t primitives) {
  std::vector<std::vector<Boxd>> boxes(primitives);
  constexpr Boxd everywhere{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  const std::function<void(std::uint32_t, const Boxd&)> descend = [&](std::uint32_t number,
                                                                      const Boxd& around) {
    const HierarchyNode& node = grid.nodes[number];
    std::uint32_t next = node.first_node;
    for (int slot = 0; slot < boxes_per_node; ++slot) {
      const std::uint32_t held = slot_byte(node.slots, slot);
      const Boxd box = common(around, decoded_box(node, slot));
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

// Of scenes stored as Stored, traced by arithmetic of type Real.
template <class Stored_, class Real_>
struct Traced {
  using Stored = Stored_;
  using Real = Real_;
};

template <class T>
class HierarchyWalks : public WalkComparison<typename T::Stored, typename T::Real> {
protected:
  using StoredReal = typename T::Stored;
  using TracedReal = typename T::Real;

  template <class MakeRay>
  void compare(TestScene<StoredReal>& scene, const Grid& grid, int rays, const MakeRay& make_ray) {
    this->compare_through(scene, hierarchy_view_of<TracedReal>(grid), rays, make_ray,
                          [] { return "a hierarchy"; });
  }
  void compare(TestScene<StoredReal>& scene, const Grid& grid, int rays) {
    const Boxd bounds = scene.bounds();
    RayMaker<StoredReal> maker(this->chance_, scene, bounds, grid);
    compare(scene, grid, rays, [&] {
      const Ray<StoredReal> made = maker.ray();
      Ray<TracedReal> ray{cast<TracedReal>(made.origin), static_cast<TracedReal>(made.t_min),
                          cast<TracedReal>(made.direction), static_cast<TracedReal>(made.t_max)};
      if (this->chance_.one_in(4)) put_on_planes(this->chance_, grid, ray);
      return ray;
    });
  }

  // Into planes of boxes of a node, or along their edges.
  static void put_on_planes(Chance& chance, const Grid& grid, Ray<TracedReal>& ray) {
    const HierarchyNode& node = grid.nodes[chance.index(grid.nodes.size())];
    const Boxd box = decoded_box(node, chance.whole(0, boxes_per_node - 1));
    for (int axis = 0; axis < 3; ++axis) {
      if (chance.one_in(2)) continue;
      ray.origin.set(axis, static_cast<TracedReal>(chance.one_in(2) ? box.min[axis] : box.max[axis]));
      if (chance.one_in(2)) ray.direction.set(axis, chance.one_in(2) ? TracedReal(0) : TracedReal(-0.0));
    }
    // Rays are traced with a direction of this size (scale_direction).
    int exponent = 0;
    std::frexp(largest_magnitude(ray.direction), &exponent);
    for (int axis = 0; axis < 3; ++axis)
      ray.direction.set(axis, std::ldexp(ray.direction[axis], -exponent));
    if (largest_magnitude(ray.direction) == 0) ray.direction = {1, 0, 0};
  }
};
using Ways = testing::Types<Traced<float, float>, Traced<float, double>, Traced<double, double>>;
TYPED_TEST_SUITE(HierarchyWalks, Ways);

TYPED_TEST(HierarchyWalks, FindTheHitsOfTryingEveryPrimitive) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(2000); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
    this->compare(scene, grid, 200);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(60'000));
}

// Several levels of nodes, with primitives large and small that overlap: some are cut by spatial splits.
TYPED_TEST(HierarchyWalks, FindThemAmongThousandsOfPrimitives) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  std::size_t cut = 0;
  for (std::int64_t s = cases(16); s > 0; --s) {
    TestScene<Stored> scene;
    const Vec3d middle = chance.in_cube(chance.one_of({0.0, 1.0, 30.0}));
    for (int i = chance.whole(500, 3000); i > 0; --i) {
      const Vec3d at = middle + chance.in_cube(1);
      const double size = chance.power_of_two(-9, chance.one_in(20) ? 0 : -4);
      const auto corner = [&] { return cast<Stored>(at + chance.in_cube(size)); };
      switch (chance.whole(0, 5)) {
      case 0:
        scene.spheres.push_back(sphere_of<Stored>(at, size));
        break;
      case 1:
        scene.cones.push_back(cone_of<Stored>(at, size, at + chance.direction() * (size * 4),
                                              size * chance.one_of({0.0, 0.5, 1.0})));
        break;
      default:
        scene.triangles.push_back(triangle_of(corner(), corner(), corner()));
      }
    }
    const Grid grid = hierarchy_of(scene, s % 2 == 0 ? HierarchyQuality::high : HierarchyQuality::fast);
    EXPECT_GT(hierarchy_statistics(grid.nodes).depth, 2);
    cut += grid.references.size() - scene.count();
    this->compare(scene, grid, 250);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(1000));
  this->RecordProperty("references_of_cut_primitives", static_cast<int>(cut));
}

TYPED_TEST(HierarchyWalks, FindThemThroughARefittedHierarchy) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(500); s > 0; --s) {
    const double scale = chance.power_of_two(-10, 20);
    TestScene<Stored> scene = SceneMaker<Stored>(chance, scale).scene();
    Grid grid = hierarchy_of(scene, any_quality(chance));
    for (int moves = chance.whole(1, 3); moves > 0; --moves) {
      const std::size_t cones = scene.cones.size();
      move_primitives(chance, scene, scale * chance.power_of_two(-20, 4));
      if (scene.cones.size() != cones) grid = hierarchy_of(scene); // one that is a point now is gone
      ASSERT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
    }
    this->compare(scene, grid, 100);
  }
  EXPECT_EQ(this->different_, 0) << this->first_;
  EXPECT_GT(this->hits_, cases(10'000));
}

TYPED_TEST(HierarchyWalks, FindThemAlongDirectionsWithTinyComponents) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  constexpr double lowest = std::is_same_v<Real, float> ? -148 : -1072;
  for (std::int64_t s = cases(500); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).flat();
    const Boxd bounds = scene.bounds();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
    int across_plane = 0;
    for (int axis = 0; axis < 3; ++axis)
      if (bounds.min[axis] == bounds.max[axis]) across_plane = axis;
    const auto place = [&] { return cast<Real>(chance.in_box(bounds)); };
    this->compare(scene, grid, 200, [&] {
      const Vec3<Real> origin = place();
      Vec3<Real> direction = place() - origin;
      direction.set(across_plane, static_cast<Real>(chance.sign() * chance.power_of_two(lowest, -20)));
      if (chance.one_in(4)) direction.set((across_plane + 1) % 3, Real(0));
      return unbounded_ray(origin, direction);
    });
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

// As large, as small and as far from the origin as scene files allow.
TYPED_TEST(HierarchyWalks, FindThemInScenesOfAnyScaleAndPlace) {
  using Stored = typename TypeParam::Stored;
  Chance& chance = this->chance_;
  const bool wide = std::is_same_v<Stored, double>;
  for (std::int64_t s = cases(400); s > 0; --s) {
    const double scale = chance.power_of_two(wide ? -298 : -31, wide ? 49 : 39);
    TestScene<Stored> scene = SceneMaker<Stored>(chance, scale).scene();
    const Boxd bounds = scene.bounds();
    const double most = wide ? 1e15 : 1e12, far = largest_magnitude(bounds);
    if (far >= most / 2) continue;
    if (chance.one_in(2)) { // far away for its size
      const Vec3<Stored> by =
          cast<Stored>(chance.direction() * std::min(far * chance.power_of_two(0, 16), most / 4));
      for (auto& t : scene.triangles)
        t.a = t.a + by, t.b = t.b + by, t.c = t.c + by;
      for (auto& sphere : scene.spheres)
        sphere.center = sphere.center + by;
      std::erase_if(scene.cones, [&](auto& cone) {
        cone.base = cone.base + by;
        cone.apex = cone.apex + by;
        return cone.base == cone.apex;
      });
      if (scene.count() == 0) continue;
    }
    const Grid grid = hierarchy_of(scene, any_quality(chance));
    this->compare(scene, grid, 200);
  }
  EXPECT_EQ(this->different_, 0) << "of " << this->hits_ << " hits: " << this->first_;
}

TYPED_TEST(HierarchyWalks, FindTheFirstOfThousandsThatAreEqual) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  TestScene<Stored> scene;
  scene.triangles.assign(5000, triangle_of<Stored>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  const SceneView<Stored> view = scene.view();
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    const Grid grid = hierarchy_of(scene, quality);
    EXPECT_EQ(grid.references.size(), 5000U);
    EXPECT_LE(hierarchy_statistics(grid.nodes).depth, 6U);
    NoCounts counts;
    const auto hit =
        nearest_hit<Robust<Real>>(view, hierarchy_view_of<Real>(grid),
                                  unbounded_ray<Real>({Real(0.25), Real(0.25), 1}, {0, 0, -1}), counts);
    EXPECT_EQ(hit.primitive, 0U);
    EXPECT_EQ(hit.t, 1);
  }
}

TYPED_TEST(HierarchyWalks, FindNothingInAnEmptyScene) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  TestScene<Stored> empty, without_surface;
  without_surface.triangles.assign(3, triangle_of<Stored>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  for (TestScene<Stored>* const scene : {&empty, &without_surface}) {
    for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
      const Grid grid = hierarchy_of(*scene, quality);
      EXPECT_EQ(grid.nodes.size(), 1U);
      EXPECT_TRUE(grid.references.empty());
      const auto ray = unbounded_ray<Real>({0, 0, 0}, {0, 0, -1});
      const auto view = hierarchy_view_of<Real>(grid);
      Counts counts;
      EXPECT_EQ(nearest_hit<Robust<Real>>(scene->view(), view, ray, counts).primitive, no_primitive);
      EXPECT_FALSE(is_occluded<Robust<Real>>(scene->view(), view, ray, counts));
    }
  }
}

TYPED_TEST(HierarchyWalks, EndForRaysOfAnyNumbers) {
  using Stored = typename TypeParam::Stored;
  using Real = typename TypeParam::Real;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(30); s > 0; --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, 1).scene();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
    const SceneView<Stored> view = scene.view();
    for (int i = 0; i < 2000; ++i) {
      const Ray<Real> ray = ray_of_any_numbers<Real>(chance);
      Counts counts;
      nearest_hit<Robust<Real>>(view, hierarchy_view_of<Real>(grid), ray, counts);
      ASSERT_LE(counts.cells_visited, grid.nodes.size());
    }
  }
}

// --- What the builder promises ---------------------------------------------------------------------------

template <class Stored>
class BuiltHierarchy : public RandomTest {};
using Stores = testing::Types<float, double>;
TYPED_TEST_SUITE(BuiltHierarchy, Stores);

// The walk is proven for hits up to 89 u M off their surface; the rest of the margin is for the walk itself.
TYPED_TEST(BuiltHierarchy, HoldsEveryPartOfEveryPrimitiveWithItsMargin) {
  using Stored = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(500); s > 0 && !this->HasFailure(); --s) {
    TestScene<Stored> scene = SceneMaker<Stored>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
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

TYPED_TEST(BuiltHierarchy, CanBeWrittenAndOpened) {
  Chance& chance = this->chance_;
  const TemporaryFolder folder;
  const std::string path = folder.file("a.grid");
  for (std::int64_t s = cases(100); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
    write_grid(grid, {{1, 2}, scene.count(), {0, 0, 0}, SpaceRule::tight, Overlap::exact, "auto", "bvh"},
               path);
    const GridFile file(path);
    ASSERT_TRUE(file.is_hierarchy());
    EXPECT_FALSE(file.is_merged());
    EXPECT_TRUE(std::ranges::equal(file.references(), grid.references));
    EXPECT_EQ(std::memcmp(file.nodes().data(), grid.nodes.data(), grid.nodes.size() * sizeof(HierarchyNode)),
              0);
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
          const Grid grid = hierarchy_of(scene, quality);
          EXPECT_LE(hierarchy_statistics(grid.nodes).depth, max_hierarchy_depth);
          EXPECT_EQ(grid.references.size(), scene.count());
          write_grid(grid,
                     {{1, 2}, scene.count(), {0, 0, 0}, SpaceRule::tight, Overlap::exact, "auto", "bvh"},
                     path);
          EXPECT_NO_THROW(const GridFile file(path));
        }
      }
    }
  }
}

TYPED_TEST(BuiltHierarchy, RefittedWhereNothingMovedIsTheSameBytes) {
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(200); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, chance.power_of_two(-10, 20)).scene();
    const Grid grid = hierarchy_of(scene, HierarchyQuality::fast); // in which nothing is divided
    Grid again = grid;
    ASSERT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), again));
    expect_same(grid, again);
    ASSERT_FALSE(this->HasFailure()) << described(scene);
  }
}

TYPED_TEST(BuiltHierarchy, IsNotRefittedWhereAPrimitiveGetsASurface) {
  TestScene<TypeParam> scene = scattered_scene<TypeParam>(this->chance_, 100);
  const Vec3<TypeParam> a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  scene.triangles.push_back(triangle_of(a, a, a));
  for (const HierarchyQuality quality : {HierarchyQuality::high, HierarchyQuality::fast}) {
    Grid grid = hierarchy_of(scene, quality);
    EXPECT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
    TestScene<TypeParam> moved = scene;
    moved.triangles.back() = triangle_of(a, b, c);
    const Grid before = grid;
    EXPECT_FALSE(refit_hierarchy(moved.view(), hierarchy_layout(moved), grid));
    expect_same(before, grid);
    grid = hierarchy_of(moved, quality); // and back: one that has lost its surface stays
    EXPECT_TRUE(refit_hierarchy(scene.view(), hierarchy_layout(scene), grid));
  }
}

TYPED_TEST(BuiltHierarchy, StatisticsCountWhatIsThere) {
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(100); s > 0; --s) {
    TestScene<TypeParam> scene = SceneMaker<TypeParam>(chance, 1).scene();
    const Grid grid = hierarchy_of(scene, any_quality(chance));
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

// Areas are computed in float32: they would be infinite.
TEST(Hierarchy, OfASceneThatReachesBeyondFloat32IsRefused) {
  TestScene<double> scene;
  scene.spheres.push_back(sphere_of<double>({0, 0, 0}, 0.99e15));
  EXPECT_NO_THROW(hierarchy_of(scene));
  scene.spheres.push_back(sphere_of<double>({2e15, 0, 0}, 1));
  try {
    hierarchy_of(scene);
    FAIL() << "it was built";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::usage);
    EXPECT_EQ(error.place(), "structure");
  }
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
    const Grid grid = hierarchy_of(scene, any_quality(chance));
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

TEST(Hierarchies, OfMorePrimitivesThanThereIsMemoryOrNumbersForAreRefused) {
  const auto said = [](std::uint64_t primitives, double available) -> std::string {
    try {
      check_hierarchy(primitives, available);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::usage);
      return error.what();
    }
    return "";
  };
  constexpr double plenty = 1e18;
  EXPECT_EQ(said(1000, 300000), "");
  EXPECT_NE(said(1000, 299999).find("free: build a grid"), std::string::npos);
  EXPECT_EQ(said(max_hierarchy_primitives, plenty), "");
  EXPECT_NE(said(max_hierarchy_primitives + 1, plenty).find("can be numbered"), std::string::npos);
  // With what is divided, references have 31 bits, and twice as many binary nodes 32.
  EXPECT_LE(static_cast<double>(max_hierarchy_primitives) * (1 + spare_fragments), 0x7fffffff);
}

} // namespace
} // namespace masu
