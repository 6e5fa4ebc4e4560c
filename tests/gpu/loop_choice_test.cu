// The loop that a GPU chooses for a list through a hierarchy, by how its rays run.
#include "renderer/cuda/rays/loop_choice.h"

#include "libscene/cuda/cuda_device.h"
#include "stability/random_seed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace masu {
namespace {

class LoopChoice : public testing::Test {
protected:
  void SetUp() override {
    std::string why;
    if (!cuda_available(why)) GTEST_SKIP() << "no GPU: " << why;
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  Vec3d direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 6.283), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  // No farther than an angle, in degrees, from another.
  Vec3d direction_near(const Vec3d& other, double angle) {
    for (;;)
      if (const Vec3d one = direction(); dot(one, other) >= std::cos(angle * 3.14159265 / 180)) return one;
  }
  // As those of ambient occlusion lie about a normal.
  Vec3d direction_about(const Vec3d& normal) { return normalized(normal + direction()); }
  // Of warps whose rays run within an angle of a direction each, or for 0 about it as about a normal; so many
  // of a hundred meet the scene, a cube of side 2.
  std::vector<Ray<float>> rays(std::size_t warps, double angle, int percent) {
    std::vector<Ray<float>> list;
    for (std::size_t warp = 0; warp < warps; ++warp) {
      const Vec3d axis = direction();
      for (int lane = 0; lane < lanes_per_warp; ++lane) {
        const Vec3d along = angle > 0 ? direction_near(axis, angle) : direction_about(axis),
                    within{uniform(-.9, .9), uniform(-.9, .9), uniform(-.9, .9)};
        const Vec3d from = within - along * 5.0,
                    away = uniform(0, 100) < percent ? Vec3d{} : Vec3d{50, 50, 50};
        list.push_back(unbounded_ray(cast<float>(from + away), cast<float>(along)));
      }
    }
    return list;
  }

  template <Query query>
  RayLoop choice(const std::vector<Ray<float>>& list) const {
    constexpr std::uint32_t parts = 3;
    const StreamMemory memory{};
    const DeviceArray<Ray<float>> there(list.data(), list.size());
    const DeviceArray<RayLoop> chosen(1);
    std::vector<std::uint32_t> fetched(parts, 7);
    const DeviceArray<std::uint32_t> fetched_there(fetched.data(), parts);
    SceneView<float> scene{};
    scene.clip = {{-1, -1, -1}, {1, 1, 1}};
    launch(choose_loop_kernel<query, float, float>, 1, warps_looked_at * lanes_per_warp, memory.stream, scene,
           there.data(), list.size(), chosen.data(), fetched_there.data(), parts);
    RayLoop loop{};
    chosen.download(&loop);
    fetched_there.download(fetched.data());
    for (const std::uint32_t rays_fetched : fetched)
      EXPECT_EQ(rays_fetched, 0);
    return loop;
  }

private:
  const RandomSeed seed_;
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
  std::mt19937_64 engine_ = seed_.engine();
};

TEST_F(LoopChoice, RaysThatRunAsTheirNeighboursDoAreTracedByAThreadEach) {
  for (const std::size_t warps : {1, 31, 32, 1000}) {
    const std::vector<Ray<float>> alike = rays(warps, 14, 100);
    EXPECT_EQ(choice<Query::nearest_hit>(alike), RayLoop::thread_per_ray) << warps;
    EXPECT_EQ(choice<Query::occlusion>(alike), RayLoop::thread_per_ray) << warps;
  }
}

TEST_F(LoopChoice, RaysThatRunAllWaysAreFetched) {
  const std::vector<Ray<float>> all_ways = rays(1000, 180, 100);
  EXPECT_EQ(choice<Query::nearest_hit>(all_ways), RayLoop::warp_refill);
  EXPECT_EQ(choice<Query::occlusion>(all_ways), RayLoop::warp_refill);
}

TEST_F(LoopChoice, ForAnyHitRaysOfOneSideAreAlikeButNotThoseAboutANormal) {
  const std::vector<Ray<float>> one_side = rays(1000, 44, 100);
  EXPECT_EQ(choice<Query::nearest_hit>(one_side), RayLoop::warp_refill);
  EXPECT_EQ(choice<Query::occlusion>(one_side), RayLoop::thread_per_ray);
  // Of one list in fifty, more than are expected run as their neighbours do by chance.
  int fetched = 0;
  for (int list = 0; list < 9; ++list)
    fetched += choice<Query::occlusion>(rays(1000, 0, 100)) == RayLoop::warp_refill ? 1 : 0;
  EXPECT_GE(fetched, 5);
}

TEST_F(LoopChoice, WhereFewRaysMeetTheSceneNothingIsFetched) {
  const std::vector<Ray<float>> few = rays(1000, 180, 10), many = rays(1000, 180, 50);
  EXPECT_EQ(choice<Query::nearest_hit>(few), RayLoop::thread_per_ray);
  EXPECT_EQ(choice<Query::nearest_hit>(many), RayLoop::warp_refill);
}

} // namespace
} // namespace masu
