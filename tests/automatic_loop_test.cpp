// The loop by which a GPU traces a list: by the costs of a sample of its rays.
#include "renderer/automatic_loop.h"

#include "tests/random_ray.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"
#include "tools/bench/stability/test_scene.h"

#include <algorithm>

namespace masu {
namespace {

Scene random_scene(SceneChance& chance) {
  Scene scene = empty_scene({0, -4, 1}, {0, 0, 0});
  for (int i = 0; i < 60; ++i) {
    const Vec3d at{chance.between(-1, 1), chance.between(-1, 1), chance.between(-1, 1)};
    add_sphere(scene, at, chance.between(0.02, 0.2), matte({1, 1, 1}));
    add_triangle(scene, at, at + chance.direction() * 0.5, at + chance.direction() * 0.5, matte({1, 1, 1}));
  }
  return scene;
}

std::vector<Ray<float>> random_rays(SceneChance& chance, std::size_t count) {
  std::vector<Ray<float>> rays(count);
  for (Ray<float>& ray : rays)
    ray = unbounded_ray(cast<float>(chance.direction() * 3.0), cast<float>(chance.direction()));
  return rays;
}

TEST(AutomaticLoop, CostsOfAListOfFewWarpsAreThoseOfItsRays) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  SceneChance chance(seed);
  for (const GridKind kind : {GridKind::uniform, GridKind::irregular, GridKind::hierarchy}) {
    GridOptions options;
    options.kind = kind;
    const Rendering rendering(random_scene(chance), Store::float32, "6x5x7", options);
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      // The last warp isn't full.
      const std::size_t warps = 1 + static_cast<std::size_t>(chance.between(0, 63));
      const std::vector<Ray<float>> rays = random_rays(chance, warps * 32 + 17);
      double work = 0, tests = 0, most_work = 0, most_tests = 0;
      for (std::size_t warp = 0; warp < warps; ++warp) {
        double longest = 0, most = 0;
        for (std::size_t i = 0; i < 32; ++i) {
          RaysRequest request;
          request.query = query;
          request.tracing.count = true;
          std::uint8_t occluded = 0;
          RayResults results;
          results.occluded = &occluded;
          const Counts counts =
              Tracer(rendering.scene(), &rendering.grid(), Device::cpu)
                  .trace(RayList(&rays[warp * 32 + i], 1, own_format<float>), results, request)
                  .counts;
          const auto of_ray = static_cast<double>(counts.triangle_tests + counts.sphere_tests);
          longest = std::max(longest, of_ray + static_cast<double>(counts.cells_visited));
          most = std::max(most, of_ray);
          work += (of_ray + static_cast<double>(counts.cells_visited)) / static_cast<double>(warps * 32);
          tests += of_ray / static_cast<double>(warps * 32);
        }
        most_work += longest / static_cast<double>(warps);
        most_tests += most / static_cast<double>(warps);
      }
      const WarpCosts costs =
          sampled_costs(rendering.scene(), rendering.grid(), rays, query, Precision::automatic);
      EXPECT_NEAR(costs.work, work, 1e-9 * work);
      EXPECT_NEAR(costs.tests, tests, 1e-9 * work);
      EXPECT_NEAR(costs.most_work, most_work, 1e-9 * most_work);
      EXPECT_NEAR(costs.most_tests, most_tests, 1e-9 * most_work);
    }
  }
}

TEST(AutomaticLoop, SamplesNothingBeyondTheList) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  SceneChance chance(seed);
  const Rendering rendering(random_scene(chance), Store::float32);
  for (const std::size_t count : {0U, 1U, 31U, 32U, 2047U, 2048U, 2079U, 2080U, 5000U}) {
    // All rays are alike: whatever is sampled, means and extremes are one ray's.
    const std::vector<Ray<float>> rays(count, random_rays(chance, 1).front());
    const WarpCosts costs =
        sampled_costs(rendering.scene(), rendering.grid(), rays, Query::nearest_hit, Precision::automatic);
    EXPECT_DOUBLE_EQ(costs.work, costs.most_work) << count;
    EXPECT_DOUBLE_EQ(costs.tests, costs.most_tests) << count;
    EXPECT_EQ(automatic_loop(costs, false), RayLoop::thread_per_ray);
  }
}

TEST(AutomaticLoop, RefillsWhereAFewRaysAreLong) {
  for (const bool is_hierarchy : {false, true}) {
    EXPECT_EQ(automatic_loop(WarpCosts{10, 5, 60, 40}, is_hierarchy), RayLoop::warp_refill);
    EXPECT_EQ(automatic_loop(WarpCosts{1, 0.5, 3, 2}, is_hierarchy), RayLoop::thread_per_ray); // too short
    EXPECT_EQ(automatic_loop(WarpCosts{10, 5, 15, 8}, is_hierarchy), RayLoop::thread_per_ray); // alike
  }
  EXPECT_EQ(automatic_loop(WarpCosts{10, 5, 15, 9}, false), RayLoop::warp);
}

} // namespace
} // namespace masu
