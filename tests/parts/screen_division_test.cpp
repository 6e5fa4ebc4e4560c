// However a picture's rays are divided among workers, each is traced once, and the picture is the same.
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"
#include "tools/bench/screen_division/screen_division.h"

namespace masu {
namespace {

using ScreenDivisions = RandomTest;

constexpr std::array all_divisions{ScreenDivision::block, ScreenDivision::cyclic, ScreenDivision::persistent};

TEST_F(ScreenDivisions, BlocksAndCyclesHoldEachTileOnceAndAboutAsMany) {
  for (const std::uint32_t tiles : {1U, 2U, 7U, 64U, 1000U}) {
    for (const std::uint32_t workers : {1U, 2U, 3U, 64U, 1001U}) {
      for (const ScreenDivision division : {ScreenDivision::block, ScreenDivision::cyclic}) {
        std::vector<int> taken(tiles, 0);
        std::uint32_t least = tiles, most = 0;
        for (std::uint32_t worker = 0; worker < workers; ++worker) {
          const TileRun run = run_of(division, worker, workers, tiles);
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

TEST_F(ScreenDivisions, EveryOneRendersTheSamePicture) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  for (int i = 0; i < 20; ++i) {
    const Vec3d center = chance_.in_cube(2);
    add_sphere(scene, center, chance_.uniform(0.1, 0.8),
               i % 3 == 0 ? mirror() : matte(random_color(chance_)));
  }
  add_light(scene, {3, 4, 5});
  const Rendering rendering(scene, Store::float32);
  FrameRequest request = rendering.request();
  request.tracing.count = request.hits = false;
  // One ray more each way: the last tiles are cut off.
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 7}, {8, 7}, {40, 23}, {64, 65}}) {
    request.camera.width = width;
    request.camera.height = height;
    const Frame expected = rendering.frame(request);
    for (const ScreenDivision division : all_divisions) {
      for (const int workers_each : {0, 1, 5, 64}) {
        const DividedFrame divided =
            render_divided_cpu(rendering.scene(), rendering.grid(), request, division, workers_each);
        EXPECT_EQ(divided.frame.radiance, expected.radiance)
            << "division " << static_cast<int>(division) << ", " << width << "x" << height << ", workers "
            << workers_each;
      }
    }
  }
}

} // namespace
} // namespace masu
