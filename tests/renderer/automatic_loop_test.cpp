// The loop by which a GPU traces a list: by the costs of a sample of its rays.
#include "renderer/rays/automatic_loop.h"

#include "tests/random_ray.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace masu {
namespace {

using AutomaticLoop = RandomTest;

Scene any_scene(Chance& chance) {
  Scene scene = empty_scene({0, -4, 1}, {0, 0, 0});
  for (int i = 0; i < 60; ++i) {
    const Vec3d at = chance.in_cube(1);
    add_sphere(scene, at, chance.uniform(0.02, 0.2), matte({1, 1, 1}));
    add_triangle(scene, at, at + chance.direction() * 0.5, at + chance.direction() * 0.5, matte({1, 1, 1}));
  }
  return scene;
}

std::vector<Ray<float>> random_rays(Chance& chance, std::size_t count) {
  std::vector<Ray<float>> rays(count);
  for (Ray<float>& ray : rays)
    ray = unbounded_ray(cast<float>(chance.direction() * 3.0), cast<float>(chance.direction()));
  return rays;
}

TEST_F(AutomaticLoop, CostsOfAListOfFewWarpsAreThoseOfItsRays) {
  for (const StructureKind kind :
       {StructureKind::uniform, StructureKind::irregular, StructureKind::hierarchy}) {
    StructureOptions options{kind};
    const Rendering rendering(any_scene(chance_), Store::float32, "6x5x7", options);
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      // The last warp isn't full.
      const std::size_t warps = 1 + static_cast<std::size_t>(chance_.uniform(0, 63));
      const std::vector<Ray<float>> rays = random_rays(chance_, warps * 32 + 17);
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
              rendering.tracer()
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
      const ResidentTracer tracer = rendering.tracer();
      const WarpCosts costs = warp_costs(tracer, rays, query, Precision::automatic);
      EXPECT_NEAR(costs.work, work, 1e-9 * work);
      EXPECT_NEAR(costs.tests, tests, 1e-9 * work);
      EXPECT_NEAR(costs.most_work, most_work, 1e-9 * most_work);
      EXPECT_NEAR(costs.most_tests, most_tests, 1e-9 * most_work);
    }
  }
}

TEST_F(AutomaticLoop, SamplesNothingBeyondTheList) {
  Scene scene = empty_scene({0, -4, 0}, {0, 0, 0});
  add_sphere(scene, {0, 0, 0}, 1, matte({1, 1, 1}));
  const Rendering rendering(scene, Store::float32);
  const ResidentTracer tracer = rendering.tracer();
  const Ray<float> hitting = unbounded_ray<float>({0.1F, -4, 0.2F}, {0, 1, 0}),
                   missing = unbounded_ray<float>({0.1F, -4, 9}, {0, 1, 0});
  const auto costs_of = [&](const std::vector<Ray<float>>& rays, std::size_t count) {
    return warp_costs(tracer, RayList(rays.data(), count, own_format<float>), Query::nearest_hit,
                      Precision::automatic);
  };
  const WarpCosts of_one = costs_of(std::vector<Ray<float>>(32, hitting), 32);
  EXPECT_GT(of_one.tests, 0);
  for (const std::size_t count : {0U, 1U, 31U, 32U, 2047U, 2048U, 2079U, 2080U, 5000U}) {
    // Behind the list stand rays that cost nothing.
    std::vector<Ray<float>> rays(count, hitting);
    rays.resize(count + 4096, missing);
    const WarpCosts costs = costs_of(rays, count);
    EXPECT_EQ(costs.work, count < 32 ? 0 : of_one.work) << count;
    EXPECT_EQ(costs.tests, count < 32 ? 0 : of_one.tests) << count;
    EXPECT_EQ(costs.most_work, count < 32 ? 0 : of_one.work) << count;
  }
}

TEST_F(AutomaticLoop, RefillsOnceAFewRaysAreLongEnoughAndKeepsToIt) {
  for (int i = 0; i < 1000; ++i) {
    const double work = chance_.power_of_two(-2, 8), tests = work * chance_.uniform(0, 1);
    for (const Query query : {Query::nearest_hit, Query::occlusion}) {
      const auto loop_of = [&](double longest) {
        return automatic_loop(WarpCosts{work, tests, longest, tests}, query);
      };
      EXPECT_EQ(loop_of(work), RayLoop::thread_per_ray); // all rays alike: none waits for another
      bool refills = false;
      for (double longest = work; longest < 100 * work + 100; longest *= 1.25) {
        const RayLoop loop = loop_of(longest);
        EXPECT_TRUE(loop == RayLoop::warp_refill || !refills) << work << ' ' << longest;
        refills = refills || loop == RayLoop::warp_refill;
      }
      EXPECT_TRUE(refills) << work;
    }
    // The others wait for the tests of a few: they are shared.
    const double few = work + 2;
    EXPECT_EQ(automatic_loop(WarpCosts{few + 10, few, 2 * few + 20, 2 * few}, Query::nearest_hit),
              RayLoop::warp)
        << work;
  }
}

TEST_F(AutomaticLoop, SharesTestsOfAFewAlsoWhereHardlyAnyRayWaits) {
  for (const Query query : {Query::nearest_hit, Query::occlusion}) {
    const WarpCosts some{4.2, 2, 6.1, 3.5}, hardly_any{0.5, 0.1, 1.4, 0.9};
    EXPECT_EQ(automatic_loop(some, query), RayLoop::warp);
    EXPECT_EQ(automatic_loop(hardly_any, query), RayLoop::thread_per_ray);
  }
}

// A rod of spheres in one voxel, which few random rays meet, and those at length.
Scene rod(const Vec3d& from, const Vec3d& at) {
  Scene scene = empty_scene(from, at);
  constexpr int spheres = 400;
  for (int i = 0; i < spheres; ++i)
    add_sphere(scene, {(i + 0.5) / spheres, 0, 0}, 0.5 / spheres, matte({1, 1, 1}));
  scene.camera.width = scene.camera.height = 64;
  return scene;
}

RayLoop usual_loop(UsualLoops& loops, const Rendering& rendering, bool coherent) {
  return loops.of(rendering.tracer(), coherent);
}

TEST(UsualLoops, OfIncoherentRaysIsThatOfRandomRaysWhateverTheCameraSees) {
  for (const Vec3d& away : {Vec3d{0.5, 2, 0}, Vec3d{0.5, 0, 0}}) {
    const Rendering rendering(rod({0.5, 1, 0}, away), Store::float32, "1");
    UsualLoops loops;
    EXPECT_EQ(usual_loop(loops, rendering, false), RayLoop::warp_refill);
  }
}

TEST(UsualLoops, OfCoherentRaysIsThatOfTheCamera) {
  UsualLoops blind, near, far;
  const Rendering nothing(rod({0.5, 1, 0}, {0.5, 2, 0}), Store::float32, "1"); // all rays miss
  EXPECT_EQ(usual_loop(blind, nothing, true), RayLoop::thread_per_ray);
  const Rendering within(rod({0.5, 0, 0}, {1, 0, 0}), Store::float32, "1"); // all rays meet all spheres
  EXPECT_EQ(usual_loop(near, within, true), RayLoop::thread_per_ray);
  Scene seen = rod({0.5, 0.5, 0}, {0.5, 0, 0});
  seen.camera.angle = 8; // those of two columns of pixels do
  const Rendering across(seen, Store::float32, "1");
  EXPECT_EQ(usual_loop(far, across, true), RayLoop::warp_refill);
}

// A thread that waits inside a loop's task takes others, which must not wait for what it is doing.
TEST(UsualLoops, MayBeAskedForByTasksWhileTheyAreFoundOut) {
  const Rendering rendering(rod({0.5, 1, 0}, {0.5, 2, 0}), Store::float32, "1");
  const ResidentTracer tracer = rendering.tracer();
  for (int round = 0; round < 20; ++round) {
    UsualLoops loops;
    tbb::parallel_for(
        tbb::blocked_range<int>(0, 64, 1),
        [&](const tbb::blocked_range<int>& range) {
          for (int i = range.begin(); i != range.end(); ++i)
            EXPECT_EQ(loops.of(tracer, i % 2 == 0),
                      i % 2 == 0 ? RayLoop::thread_per_ray : RayLoop::warp_refill);
        },
        tbb::simple_partitioner());
  }
}

} // namespace
} // namespace masu
