// Closest points: the same for every structure, on the surface, and none closer. And winding numbers: within
// their bound of the sum over all triangles, whichever hierarchy it is.
#include "libgrid/trace/closest.h"
#include "libgrid/trace/winding.h"
#include "stability/closed_mesh.h"
#include "stability/oracle/oracle.h"
#include "tests/random_grid.h"
#include "tests/random_ray.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/surface_point.h"

#include <gtest/gtest.h>

namespace masu {
namespace {

template <class Primitive>
double off_surface(const Primitive& primitive, const Vec3d& point) {
  return static_cast<double>(oracle::distance(oracle::point(point), primitive));
}

template <class Real>
class ClosestPoints : public RandomTest {};
TYPED_TEST_SUITE(ClosestPoints, Reals);

TYPED_TEST(ClosestPoints, AreThoseOfTryingEveryPrimitive) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::size_t found = 0;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-30, 36)).scene();
    if (scene.count() == 0) continue;
    const SceneView<Real> view = scene.view();
    const Structure grid = random_grid(chance, view, scene.bounds()),
                    hierarchy = hierarchy_of(scene, any_quality(chance));
    RayMaker<Real> rays(chance, scene, scene.bounds(), grid);
    const std::uint32_t mask = 1;
    for (int p = 0; p < 100; ++p) {
      const Vec3d place = cast<double>(rays.ray().origin);
      HitFilter filter;
      if (chance.one_in(3)) filter.excluded = static_cast<PrimitiveIndex>(chance.index(scene.count()));
      filter.object_masks = &mask; // of the only object
      if (chance.one_in(8)) filter.ray_mask = 2;
      const ClosestPrimitive expected = closest_primitive(view, NoStructure{}, place, filter),
                             closest =
                                 closest_primitive(view, hierarchy_view_of<Real>(hierarchy), place, filter);
      ASSERT_EQ(closest.primitive, expected.primitive) << described(cast<Real>(place), {});
      ASSERT_EQ(closest.closest.squared, expected.closest.squared);
      ASSERT_EQ(closest.closest.point, expected.closest.point);
      found += closest.primitive != no_primitive ? 1 : 0;
      ASSERT_TRUE(filter.ray_mask != 2 || closest.primitive == no_primitive);
    }
  }
  EXPECT_GT(found, static_cast<std::size_t>(cases(10'000)));
}

TYPED_TEST(ClosestPoints, AreOnTheSurfaceAndNoneIsCloser) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  for (std::int64_t s = cases(300); s > 0; --s) {
    TestScene<Real> scene = SceneMaker<Real>(chance, chance.power_of_two(-10, 20)).scene();
    const SceneView<Real> view = scene.view();
    const Structure grid = random_grid(chance, view, scene.bounds());
    RayMaker<Real> rays(chance, scene, scene.bounds(), grid);
    for (PrimitiveIndex i = 0; i < scene.count(); ++i) {
      const Vec3d place = cast<double>(rays.ray().origin);
      const double largest = largest_magnitude(place) + largest_magnitude(scene.bounds());
      if (!(largest <= max_closest)) continue;
      const double tolerance = 0x1p-46 * largest;
      with_primitive(view, i, [&](const auto& primitive) {
        if (!has_surface(primitive)) return;
        const ClosestPoint closest = closest_point(primitive, place);
        const double distance = std::sqrt(closest.squared);
        ASSERT_NEAR(length(place - closest.point), distance, tolerance) << i;
        ASSERT_LE(off_surface(primitive, closest.point), tolerance) << i;
        for (int k = 0; k < 20; ++k)
          ASSERT_LE(distance, length(place - on_surface(chance, primitive).at) + tolerance) << i;
      });
    }
  }
}

using ClosestPointOfCone = RandomTest;

// There only roundings say which way is outward.
TEST_F(ClosestPointOfCone, IsOnTheSurfaceFromTheAxisAndNearIt) {
  for (std::int64_t s = cases(20'000); s > 0; --s) {
    const Cone<double> cone{chance_.in_cube(1), chance_.uniform(0.1, 1), chance_.in_cube(1),
                            chance_.uniform(0.1, 1)};
    const double off = chance_.one_in(3) ? 0 : chance_.power_of_two(-600, -30);
    const Vec3d axis = cone.apex - cone.base;
    const Vec3d on_axis = chance_.one_in(3) ? cone.apex : cone.base + axis * chance_.uniform(-1, 2);
    const Vec3d place = on_axis + across(chance_, axis) * off;
    const ClosestPoint closest = closest_point(cone, place);
    const double distance = std::sqrt(closest.squared), tolerance = 0x1p-44;
    ASSERT_NEAR(length(place - closest.point), distance, tolerance);
    ASSERT_LE(off_surface(cone, closest.point), tolerance);
    ASSERT_LE(distance, length(place - on_surface(chance_, cone).at) + tolerance);
  }
}

// A face's projection, an edge, a corner; between spheres; from a cone's axis. Of two as close the first.
TEST(ClosestPoint, OfKnownPlaces) {
  TestScene<float> scene;
  scene.triangles = {triangle_of<float>({0, 0, 0}, {4, 0, 0}, {0, 4, 0}),
                     triangle_of<float>({0, 0, 2}, {4, 0, 2}, {0, 4, 2})};
  scene.spheres = {sphere_of<float>({10, 0, 0}, 1), sphere_of<float>({14, 0, 0}, -2)};
  scene.cones = {cone_of<float>({0, 20, 0}, 1, {0, 20, 4}, 1)};
  const SceneView<float> view = scene.view();
  const auto expect = [&](const Vec3d& place, PrimitiveIndex primitive, const Vec3d& point, double distance) {
    const ClosestPrimitive found = closest_primitive(view, NoStructure{}, place, {});
    EXPECT_EQ(found.primitive, primitive);
    EXPECT_EQ(found.closest.point, point);
    EXPECT_EQ(found.closest.squared, distance * distance);
  };
  expect({1, 1, 0.5}, 0, {1, 1, 0}, 0.5);
  expect({1, 1, 1}, 0, {1, 1, 0}, 1); // or the second
  expect({1, -3, 2}, 1, {1, 0, 2}, 3);
  expect({-3, -4, 0}, 0, {0, 0, 0}, 5);
  expect({11.5, 0, 0}, 2, {11, 0, 0}, 0.5);
  expect({13, 0, 0}, 3, {12, 0, 0}, 1); // inside
  const ClosestPrimitive on_axis = closest_primitive(view, NoStructure{}, {0, 20, 2}, {});
  EXPECT_EQ(on_axis.primitive, 4U);
  EXPECT_EQ(on_axis.closest.squared, 1);
  const ClosestPoint near_center = closest_point(Sphere<double>{{0, 0, 0}, 1}, {0x1p-540, 0, -0x1p-540});
  EXPECT_NEAR(length(near_center.point), 1, 0x1p-50);
  EXPECT_EQ(closest_primitive(view, NoStructure{}, {NAN, 0, 0}, {}).primitive, no_primitive);
  EXPECT_EQ(closest_primitive(view, NoStructure{}, {0, INFINITY, 0}, {}).primitive, no_primitive);
}

// --- Winding numbers -------------------------------------------------------------------------------------

template <class Real>
class WindingNumbers : public RandomTest {};
TYPED_TEST_SUITE(WindingNumbers, Reals);

template <class Real>
struct Wound {
  TestScene<Real> scene;
  Structure hierarchy;
  SceneView<Real> view{};
  WindingClusters clusters;

  Wound(Chance& chance, std::vector<Triangle<Real>> triangles) {
    scene.triangles = std::move(triangles);
    hierarchy = hierarchy_of(scene, any_quality(chance));
    view = scene.view();
    clusters = winding_clusters(view, nodes(), hierarchy.nodes.size(), hierarchy.references.size());
  }
  HierarchyView<Real> nodes() const { return {hierarchy.nodes.data(), hierarchy.references.data()}; }
  double number(const Vec3d& place, double bound, bool side) const {
    std::vector<UndividedCluster> room;
    return winding_number(view, nodes(), clusters, place, bound, side, room);
  }
};

TYPED_TEST(WindingNumbers, AreWithinTheBoundOfTheSumOverAllTriangles) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  std::int64_t inside = 0;
  for (std::int64_t s = cases(200); s > 0; --s) {
    const double size = chance.power_of_two(-20, 20);
    std::vector<Triangle<Real>> triangles = closed_mesh<Real>(chance, size, true);
    for (int meshes = chance.whole(0, 3); meshes > 0; --meshes) { // that overlap
      const auto others = closed_mesh<Real>(chance, size * chance.uniform(0.5, 2), false);
      triangles.insert(triangles.end(), others.begin(), others.end());
    }
    if (chance.one_in(2)) triangles.resize((triangles.size() + 1) / 2); // open
    for (Triangle<Real>& triangle : triangles)
      if (chance.one_in(20)) std::swap(triangle.a, triangle.b);
    const Wound<Real> wound(chance, triangles);
    for (int p = 0; p < 100; ++p) {
      const Vec3d place = chance.in_cube(size * chance.one_of({1.0, 2.0, 10.0}));
      const double expected = winding_number(std::span<const Triangle<Real>>(triangles), place),
                   bound = chance.power_of_two(-30, 0);
      std::vector<UndividedCluster> none;
      ASSERT_NEAR(winding_number(wound.view, HierarchyView<Real>{}, {}, place, 0, false, none), expected,
                  1e-9);
      ASSERT_NEAR(wound.number(place, bound, false), expected, bound + 1e-9);
      if (std::abs(expected - 0.5) > 0x1p-10) {
        ASSERT_EQ(wound.number(place, 0x1p-10, true) > 0.5, expected > 0.5);
      }
      inside += expected > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, cases(1000));
}

// Far fewer clusters are divided than there are triangles.
TYPED_TEST(WindingNumbers, AreOneInsideAndZeroOutsideOfClosedMeshes) {
  using Real = TypeParam;
  Chance& chance = this->chance_;
  const Mesh<double> sphere = octahedron(chance, 6, 0);
  std::vector<Triangle<Real>> triangles;
  for (const auto& [a, b, c] : sphere.faces) {
    const Vec3d &p = sphere.corners[a], &q = sphere.corners[b], &r = sphere.corners[c];
    const bool out = dot(cross(q - p, r - p), p + q + r) > 0;
    triangles.push_back(triangle_of<Real>(p, out ? q : r, out ? r : q));
  }
  const Wound<Real> wound(chance, triangles);
  std::vector<UndividedCluster> room;
  for (std::int64_t s = cases(2000); s > 0; --s) {
    const double distance = chance.one_of({chance.uniform(0, 0.99), chance.uniform(1.01, 3)});
    const Vec3d place = chance.direction() * distance;
    const double number = winding_number(wound.view, wound.nodes(), wound.clusters, place, 0, true, room);
    ASSERT_EQ(number > 0.5, distance < 1);
    if (std::abs(distance - 1) > 0.2) {
      ASSERT_LT(room.size(), triangles.size() / 100);
    }
    ASSERT_NEAR(wound.number(place, 1e-3, false), distance < 1 ? 1 : 0, 1e-3);
  }
}

} // namespace
} // namespace masu
