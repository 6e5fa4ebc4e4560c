// Camera rays follow the view: right-handed, upright, through the corners or centres of pixels.
#include "renderer/image/image.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace masu {
namespace {

using CameraRays = RandomTest;
using Images = RandomTest;

struct View {
  Vec3d forward, right, up; // of unit length
};

// A camera of any direction, with an up vector that isn't perpendicular to it.
View random_view(Chance& chance, Camera& camera) {
  camera.from = chance.direction() * chance.uniform(0, 5);
  const Vec3d forward = chance.direction();
  camera.at = camera.from + forward * chance.uniform(0.5, 20);
  camera.up = random_towards(chance, forward, -0.9);
  while (std::abs(dot(camera.up, forward)) > 0.9)
    camera.up = chance.direction();
  camera.up = camera.up * chance.uniform(0.1, 10);
  const Vec3d right = normalized(cross(forward, camera.up));
  return {forward, right, cross(right, forward)};
}

TEST_F(CameraRays, ImageIsUprightAndNotMirrored) {
  for (int i = 0; i < 30; ++i) {
    Scene scene = empty_scene({0, 0, 5}, {0, 0, 0}); // 90°, 3×3 corner rays
    const View view = random_view(chance_, scene.camera);
    std::vector<std::size_t> rays;
    for (const int x : {-1, 0, 1}) {
      for (const int y : {-1, 0, 1}) {
        const Vec3d towards = view.forward + view.right * double(x) + view.up * double(y);
        add_sphere(scene, scene.camera.from + towards * 5.0, 0.1, matte({1, 1, 1}));
        rays.push_back(static_cast<std::size_t>((1 - y) * 3 + x + 1)); // rows from the top
      }
    }
    const Frame frame = Rendering(scene, Store::float64).frame();
    for (std::size_t sphere = 0; sphere < rays.size(); ++sphere)
      EXPECT_EQ(frame.hits[rays[sphere]].name, static_cast<std::int32_t>(sphere));
  }
}

TEST_F(CameraRays, RaysPassThroughPixelCornersOrCentres) {
  for (int i = 0; i < 30; ++i) {
    Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
    const View view = random_view(chance_, scene.camera);
    const double distance = chance_.uniform(1, 10);
    scene.camera.angle = chance_.uniform(1, 120);
    scene.camera.width = chance_.whole(1, 8);
    scene.camera.height = chance_.whole(1, 8);
    add_wall(scene, scene.camera.from + view.forward * distance, view.forward, matte({1, 1, 1}), 1e3);
    const Rendering rendering(scene, Store::float64);
    for (const Sampling sampling : {Sampling::corners, Sampling::centers}) {
      FrameRequest request = rendering.request();
      request.sampling = sampling;
      const Frame frame = rendering.frame(request);
      const bool corners = sampling == Sampling::corners;
      ASSERT_EQ(frame.columns, scene.camera.width + (corners ? 1 : 0));
      ASSERT_EQ(frame.rows, scene.camera.height + (corners ? 1 : 0));
      ASSERT_EQ(frame.hits.size(), static_cast<std::size_t>(frame.columns * frame.rows));
      // The angle spans the height from edge to edge; pixels are square.
      const double pixel = 2 * std::tan(scene.camera.angle / 360 * std::numbers::pi) / scene.camera.height;
      for (std::int32_t row = 0; row < frame.rows; ++row) {
        for (std::int32_t column = 0; column < frame.columns; ++column) {
          const double offset = corners ? 0 : 0.5;
          const double x = (column + offset - scene.camera.width / 2.0) * pixel;
          const double y = (row + offset - scene.camera.height / 2.0) * pixel;
          const HitRecord hit = frame.hits[static_cast<std::size_t>(row * frame.columns + column)];
          ASSERT_EQ(hit.name, 0);
          EXPECT_NEAR(hit.t / (distance * std::sqrt(1 + x * x + y * y)), 1, 1e-6);
        }
      }
    }
  }
}

Scene scene_of_balls(Chance& chance, std::int32_t width, std::int32_t height, int balls, double away) {
  Scene scene = empty_scene({0, 0, 5}, {0, 0, 0});
  scene.camera.width = width;
  scene.camera.height = height;
  for (int i = 0; i < balls; ++i)
    add_sphere(scene, chance.direction() * chance.uniform(0, away), chance.uniform(0.1, 0.8),
               matte(random_color(chance)));
  return scene;
}

// Every value is written: of rays that miss the scene, too.
TEST_F(CameraRays, APictureInUsedMemoryIsTheSame) {
  const Rendering rendering(scene_of_balls(chance_, 70, 41, 3, 1), Store::float32);
  for (const StructureFile* const grid : {&rendering.grid(), static_cast<const StructureFile*>(nullptr)}) {
    const ResidentTracer tracer(rendering.scene(), grid, Device::cpu);
    Frame memory;
    for (int i = 0; i < 40; ++i) {
      FrameRequest request = rendering.request();
      request.hits = chance_.one_in(2);
      request.costs = chance_.one_in(2);
      request.tracing.count = request.costs;
      request.window = {chance_.whole(0, 34), chance_.whole(0, 19), chance_.whole(1, 35),
                        chance_.whole(1, 20)};
      const Frame fresh = tracer.render(request, 0);
      if (i % 2 == 0) memory = used_memory(static_cast<std::size_t>(chance_.uniform(0, 3000)));
      memory = tracer.render(request, 0, std::move(memory));
      ASSERT_EQ(memory.columns, request.window.columns);
      ASSERT_EQ(memory.rows, request.window.rows);
      expect_same_frames(fresh, memory);
      EXPECT_EQ(fresh.counts.cells_visited, memory.counts.cells_visited);
    }
  }
}

TEST_F(CameraRays, AWindowHasTheSameBitsAsTheWhole) {
  const Scene scene = scene_of_balls(chance_, 37, 29, 20, 3);
  for (const Store store : {Store::float32, Store::float64}) {
    const Rendering rendering(scene, store);
    for (const Sampling sampling : {Sampling::corners, Sampling::centers}) {
      FrameRequest request = rendering.request();
      request.sampling = sampling;
      const Frame whole = rendering.frame(request);
      for (int i = 0; i < 10; ++i) {
        RayWindow& window = request.window;
        window.first_column = chance_.whole(0, whole.columns - 1);
        window.first_row = chance_.whole(0, whole.rows - 1);
        window.columns = chance_.whole(1, whole.columns - window.first_column);
        window.rows = chance_.whole(1, whole.rows - window.first_row);
        const Frame part = rendering.frame(request);
        ASSERT_EQ(part.columns, window.columns);
        ASSERT_EQ(part.rows, window.rows);
        for (std::int32_t row = 0; row < part.rows; ++row) {
          const std::int32_t in_part = row * part.columns,
                             in_whole = (window.first_row + row) * whole.columns + window.first_column;
          const auto same_row = [&](const auto& some, const auto& all) {
            const auto columns = static_cast<std::size_t>(part.columns);
            return same_values(std::span(some).subspan(static_cast<std::size_t>(in_part), columns),
                               std::span(all).subspan(static_cast<std::size_t>(in_whole), columns));
          };
          EXPECT_TRUE(same_row(part.radiance, whole.radiance));
          EXPECT_TRUE(same_row(part.hits, whole.hits));
        }
      }
    }
  }
}

TEST_F(CameraRays, AWindowOutsideThePictureIsRefused) {
  const Rendering rendering(empty_scene({0, 0, 5}, {0, 0, 0}), Store::float32); // 3×3 corner rays
  for (const RayWindow& window : {RayWindow{-1, 0, 1, 1}, RayWindow{0, -1, 1, 1}, RayWindow{3, 0, 1, 1},
                                  RayWindow{0, 3, 1, 1}, RayWindow{1, 0, 3, 1}, RayWindow{0, 1, 1, 3},
                                  RayWindow{0, 0, 1, 0}, RayWindow{1, 1, 0x7fffffff, 1}}) {
    FrameRequest request = rendering.request();
    request.window = window;
    EXPECT_THROW(static_cast<void>(rendering.frame(request)), Error);
  }
}

TEST_F(CameraRays, HitherClipsOnlyOnRequest) {
  Scene scene = empty_scene({0, 0, 0}, {0, 0, -1});
  scene.camera.hither = 2;
  scene.camera.angle = 1;
  add_wall(scene, {0, 0, -1}, {0, 0, 1}, matte({1, 0, 0}));
  add_wall(scene, {0, 0, -3}, {0, 0, 1}, matte({0, 1, 0}));
  const Rendering rendering(scene, Store::float32);
  FrameRequest request = rendering.request();
  EXPECT_EQ(rendering.frame(request).hits[4].name, 0);
  request.hither = true;
  EXPECT_EQ(rendering.frame(request).hits[4].name, 1);
}

TEST_F(Images, PixelIsTheMeanOfItsCornersOrItsCentre) {
  Frame frame;
  frame.columns = 4;
  frame.rows = 3;
  for (int i = 0; i < 12; ++i)
    frame.radiance.push_back(random_color(chance_));
  const auto rows = [&](Sampling sampling) { // from the bottom up
    const std::vector<std::uint8_t> bytes = pfm_rows(frame, sampling);
    std::vector<Vec3f> pixels(bytes.size() / sizeof(Vec3f));
    std::memcpy(pixels.data(), bytes.data(), bytes.size());
    return pixels;
  };
  const std::vector<Vec3f> corners = rows(Sampling::corners), centers = rows(Sampling::centers);
  ASSERT_EQ(corners.size(), 3U * 2U);
  for (std::size_t y = 0; y < 2; ++y) {
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t i = y * 4 + x;
      for (int channel = 0; channel < 3; ++channel) {
        const float sum = frame.radiance[i][channel] + frame.radiance[i + 1][channel] +
                          frame.radiance[i + 4][channel] + frame.radiance[i + 5][channel];
        EXPECT_FLOAT_EQ(corners[(1 - y) * 3 + x][channel], sum / 4);
      }
    }
  }
  ASSERT_EQ(centers.size(), 4U * 3U);
  for (std::size_t y = 0; y < 3; ++y)
    EXPECT_TRUE(std::ranges::equal(std::span(centers).subspan(4 * (2 - y), 4),
                                   std::span(frame.radiance).subspan(4 * y, 4)));
}

} // namespace
} // namespace masu
