// Exact hits are those of the 113-bit oracle where that is sure; edges and corners belong to all their
// triangles.
#include "stability/oracle/closest_hit.h"
#include "stability/oracle/exact_hit.h"
#include "stability/sweeps/sweep.h"
#include "tests/random_test.h"

namespace masu::stability {
namespace {

class ExactHit : public RandomTest {
protected:
  void SetUp() override {
    if (!exact_hits_available) GTEST_SKIP() << "built without GMP: install libgmp-dev";
  }
};

TEST_F(ExactHit, IsTheOraclesWhereThatIsSure) {
  int sure = 0, hits = 0;
  for (int round = 0; round < 20; ++round) {
    const double size = chance_.power_of_two(-20, 20);
    TestScene<float> scene = random_scene<float>(chance_, {0, 0, 0}, size, Kinds::triangles);
    const oracle::SceneOracle oracle(scene.view());
    for (const Ray<double>& ray : rays_around<float>(chance_, {0, 0, 0}, size, 100)) {
      const oracle::ClosestHit expected = oracle.closest(ray, size * 1e-20);
      const std::vector<PrimitiveIndex> nearest = exact_nearest(scene.triangles, ray);
      if (!expected.sure) continue;
      ++sure;
      EXPECT_EQ(nearest.empty(), expected.candidates.empty()) << described(ray.origin, ray.direction);
      for (const PrimitiveIndex primitive : nearest) {
        ++hits;
        EXPECT_NE(expected.find(primitive), nullptr) << described(ray.origin, ray.direction);
      }
    }
  }
  EXPECT_GT(sure, 1000);
  EXPECT_GT(hits, 100);
}

TEST_F(ExactHit, OfACornerIsAllItsTrianglesInOrder) {
  for (int round = 0; round < 100; ++round) {
    // Small whole numbers, so that rays meet corners exactly.
    const Vec3d corner{0.0 + chance_.whole(-9, 9), 0.0 + chance_.whole(-9, 9), 0};
    const auto below = [&](double x, double y) { return corner + Vec3d{x, y, -1}; };
    TestScene<float> scene;
    scene.triangles = {triangle_of<float>(corner, below(1, 0), below(0, 1)),
                       triangle_of<float>({-20, -20, -5}, {20, -20, -5}, {0, 40, -5}), // behind
                       triangle_of<float>(below(0, 1), corner, below(-1, -1)),
                       triangle_of<float>(below(-1, -1), below(1, 0), corner)};
    const Vec3d from{0.0 + chance_.whole(-9, 9), 0.0 + chance_.whole(-9, 9), 100.0 + chance_.whole(0, 9)};
    EXPECT_EQ(exact_nearest(scene.triangles, unbounded_ray(from, corner - from)),
              (std::vector<PrimitiveIndex>{0, 2, 3}))
        << described(from, corner - from);
    EXPECT_TRUE(exact_nearest(scene.triangles, unbounded_ray(from, from - corner)).empty());
  }
}

TEST_F(ExactHit, IsNoTriangleSeenEdgeOn) {
  const std::vector<Triangle<float>> triangles{triangle_of<float>({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};
  EXPECT_TRUE(exact_nearest(triangles, unbounded_ray(Vec3d{-1, 0.25, 0}, Vec3d{1, 0, 0})).empty());
  // Nor one that the ray starts on.
  EXPECT_TRUE(exact_nearest(triangles, unbounded_ray(Vec3d{0.25, 0.25, 0}, Vec3d{0, 0, 1})).empty());
}

} // namespace
} // namespace masu::stability
