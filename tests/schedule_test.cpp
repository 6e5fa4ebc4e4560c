// Who traces which part of a picture doesn't show in it.
#include "renderer/schedule.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace masu {
namespace {

constexpr std::array all_schedules{Schedule::hardware, Schedule::block, Schedule::cyclic,
                                   Schedule::persistent};

TEST(Schedules, BlocksAndCyclesTakeEachTileOnceAndAboutAsMany) {
  for (const std::uint32_t tiles : {1U, 2U, 7U, 64U, 1000U}) {
    for (const std::uint32_t workers : {1U, 2U, 3U, 64U, 1001U}) {
      for (const Schedule schedule : {Schedule::hardware, Schedule::block, Schedule::cyclic}) {
        std::vector<int> taken(tiles, 0);
        std::uint32_t least = tiles, most = 0;
        for (std::uint32_t worker = 0; worker < workers; ++worker) {
          const TileRun run = run_of(schedule, worker, workers, tiles);
          std::uint32_t count = 0;
          for (std::uint32_t tile = run.first; tile < run.end; tile += run.step, ++count)
            ++taken.at(tile);
          least = std::min(least, count);
          most = std::max(most, count);
        }
        EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), tiles) << workers << " workers";
        EXPECT_LE(most - least, 1U) << tiles << " tiles, " << workers << " workers";
      }
    }
  }
}

TEST(Schedules, AllMakeTheSamePicture) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  SceneChance chance(seed);
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  for (int i = 0; i < 20; ++i) {
    const Vec3d center{chance.between(-2, 2), chance.between(-2, 2), chance.between(-2, 2)};
    add_sphere(scene, center, chance.between(0.1, 0.8), i % 3 == 0 ? mirror() : matte(chance.color()));
  }
  add_light(scene, {3, 4, 5});
  const Rendering rendering(scene, Store::automatic);
  FrameRequest request = rendering.request();
  // One ray more each way: the last tiles are cut off.
  for (const auto& size : {std::pair{1, 1}, {7, 7}, {8, 7}, {40, 23}, {64, 65}}) {
    request.camera.width = size.first;
    request.camera.height = size.second;
    request.schedule = Schedule::hardware;
    const Frame expected = rendering.frame(request);
    for (const Schedule schedule : all_schedules) {
      for (const int workers_each : {0, 1, 5, 64}) {
        request.schedule = schedule;
        request.workers_each = workers_each;
        const Frame frame = rendering.frame(request);
        const auto what = [&] {
          return "schedule " + std::to_string(static_cast<int>(schedule)) + ", " +
                 std::to_string(size.first) + "x" + std::to_string(size.second) + ", workers " +
                 std::to_string(workers_each);
        };
        EXPECT_EQ(frame.radiance, expected.radiance) << what();
        ASSERT_EQ(frame.hits.size(), expected.hits.size());
        EXPECT_EQ(
            std::memcmp(frame.hits.data(), expected.hits.data(), frame.hits.size() * sizeof(frame.hits[0])),
            0)
            << what();
        EXPECT_TRUE(
            std::equal(frame.counts.begin(), frame.counts.begin() + Counts::fields, expected.counts.begin()))
            << what();
      }
    }
  }
}

} // namespace
} // namespace masu
