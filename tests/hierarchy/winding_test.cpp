// Winding numbers: within their bound of the sum over all triangles, whichever hierarchy it is.
#include "libgrid/trace/winding.h"
#include "stability/closed_mesh.h"
#include "tests/random_grid.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

namespace masu {
namespace {

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
    triangles.push_back(triangle_of(cast<Real>(p), cast<Real>(out ? q : r), cast<Real>(out ? r : q)));
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
