// `--precision auto` follows the view: float32's errors are never seen, and double is taken nowhere else.
#include "renderer/view_precision.h"

#include "libscene/nff/nff.h"
#include "libscene/spd/spd.h"
#include "tests/rendering.h"
#include "tests/scene_builder.h"
#include "tests/stability/test_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

namespace masu {
namespace {

void add_quad(Scene& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d,
              const Material& material) {
  add_triangle(scene, a, b, c, material);
  add_triangle(scene, a, c, d, material);
}

// Needles of 1e-4 by 1e-6 on a floor of 2 by 2, seen from among them.
Scene needles(Chance& chance) {
  Scene scene = empty_scene({3e-4, -2e-4, 1.5e-4}, {0, 0, 3e-5});
  scene.camera.up = {0, 0, 1};
  scene.camera.angle = 40;
  scene.camera.width = scene.camera.height = 128;
  scene.ambient = 0.3F;
  scene.lights = {{{5e-4, 1e-3, 1e-3}, {0.7, 0.7, 0.7}}};
  add_quad(scene, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, matte({0.9F, 0.9F, 0.8F}));
  for (int i = 0; i < 300; ++i) {
    const Vec3d base{chance.uniform(-1e-4, 1e-4), chance.uniform(-1e-4, 1e-4), 0};
    const Vec3d lean{chance.uniform(-2e-5, 2e-5), chance.uniform(-2e-5, 2e-5), 1e-4};
    add_cone(scene, {base, 5e-7, base + lean, chance.one_in(2) ? 0 : 5e-7}, matte({0.2F, 0.6F, 0.3F}));
  }
  return scene;
}

// Mirrors and nested balls of glass, a kilometre from zero.
Scene far_glass(Chance& chance) {
  const Vec3d at{1000, -500, 250};
  Scene scene = empty_scene(at + Vec3d{3, -4, 2.5}, at);
  scene.camera.up = {0, 0, 1};
  scene.camera.angle = 40;
  scene.camera.width = scene.camera.height = 128;
  scene.ambient = 0.3F;
  scene.lights = {{at + Vec3d{4, -2, 6}, {0.7, 0.7, 0.7}}};
  add_quad(scene, at + Vec3d{-3, -3, -1}, at + Vec3d{3, -3, -1}, at + Vec3d{3, 3, -1}, at + Vec3d{-3, 3, -1},
           matte({0.9F, 0.5F, 0.3F}));
  add_quad(scene, at + Vec3d{-3, 3, -1}, at + Vec3d{3, 3, -1}, at + Vec3d{3, 3, 3}, at + Vec3d{-3, 3, 3},
           mirror());
  for (int i = 0; i < 6; ++i) {
    const Vec3d center =
        at + Vec3d{chance.uniform(-1.5, 1.5), chance.uniform(-1.5, 1.5), chance.uniform(-0.6, 1)};
    for (const double radius : {0.4, 0.3, 0.2})
      add_sphere(scene, center, radius, glass(1.5F));
  }
  return scene;
}

// The share of pixels of which a channel is off by more than a fiftieth.
double pixels_off(const Frame& a, const Frame& b) {
  const auto pixel = [](const Frame& frame, std::int32_t x, std::int32_t y) {
    const auto at = [&](std::int32_t column, std::int32_t row) {
      return frame.radiance[static_cast<std::size_t>(row * frame.columns + column)];
    };
    return (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) * 0.25F;
  };
  int off = 0, all = 0;
  for (std::int32_t y = 0; y + 1 < a.rows; ++y) {
    for (std::int32_t x = 0; x + 1 < a.columns; ++x, ++all)
      off += largest_magnitude(pixel(a, x, y) - pixel(b, x, y)) > 0.02F ? 1 : 0;
  }
  return static_cast<double>(off) / all;
}

Frame picture(const Rendering& rendering, Precision precision) {
  FrameRequest request = rendering.request();
  request.tracing.precision = precision;
  return rendering.frame(request);
}

void expect_right(const char* name, const Scene& scene) {
  const Rendering usual(scene, Store::automatic), exact(scene, Store::float64, "auto", {}, Vec3d{0, 0, 0});
  EXPECT_FALSE(usual.scene().is_float64());
  const Frame reference = picture(exact, Precision::doubled);
  const double robust = pixels_off(picture(usual, Precision::robust), reference);
  const double automatic = pixels_off(picture(usual, Precision::automatic), reference);
  testing::Test::RecordProperty(std::string(name) + "_robust", std::to_string(robust));
  testing::Test::RecordProperty(std::string(name) + "_auto", std::to_string(automatic));
  EXPECT_LT(automatic, 1e-3) << name << ": of robust " << robust;
}

TEST(ViewPrecision, PicturesOfSmallThingsOnALargeFloorAreRight) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  expect_right("needles", needles(chance));
}

TEST(ViewPrecision, PicturesOfGlassFarFromZeroAreRight) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  expect_right("far_glass", far_glass(chance));
}

// A wall seen head-on, from nearer and nearer.
TEST(ViewPrecision, IsDoubleWhereABoundIsMoreThanASixteenthOfAPixel) {
  for (double distance = 4; distance > 1e-6; distance /= 1.5) {
    Scene scene = empty_scene({0.25, 0, distance}, {0.25, 0, 0});
    scene.camera.angle = 30;
    scene.camera.width = scene.camera.height = 100;
    add_quad(scene, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, matte({1, 1, 1}));
    add_sphere(scene, {0.25, 0, distance + 1}, 0.5, matte({1, 1, 1})); // behind the camera
    const Rendering rendering(scene, Store::float32);
    const double bound = rounding_margin<float>(rendering.scene().bounds()) / 4;
    const double pixel = 2 * std::tan(15 * std::numbers::pi / 180) / 100 * distance;
    const Tracer tracer(rendering.scene(), &rendering.grid(), Device::cpu);
    FrameRequest request = rendering.request();
    const ViewPrecision chosen = view_precision(tracer, request);
    if (std::abs(16 * bound / pixel - 1) < 1e-3) continue;
    EXPECT_EQ(chosen.precision, 16 * bound > pixel ? Precision::doubled : Precision::robust) << distance;
    EXPECT_EQ(view_precision(Tracer(rendering.scene(), nullptr, Device::cpu), request).precision,
              chosen.precision);
    // The picture is the chosen one's, bit for bit, in parts as well.
    request.window = {10, 20, 30, 12};
    const Frame part = rendering.frame(request);
    request.tracing.precision = chosen.precision;
    expect_same_frames(rendering.frame(request), part);
  }
}

TEST(ViewPrecision, IsDoubleForAStoreOfDoublesAndRobustForNothing) {
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  Chance chance(seed);
  const Rendering stored(needles(chance), Store::float64);
  const Tracer tracer(stored.scene(), &stored.grid(), Device::cpu);
  EXPECT_EQ(view_precision(tracer, stored.request()).precision, Precision::doubled);
  EXPECT_TRUE(view_precision(tracer, stored.request()).is_stored);
  const Rendering nothing(empty_scene({0, 0, 1e-20}, {0, 0, 0}), Store::automatic);
  EXPECT_EQ(
      view_precision(Tracer(nothing.scene(), &nothing.grid(), Device::cpu), nothing.request()).precision,
      Precision::robust);
}

// As long as their errors can't be seen: doubled takes half as long again.
TEST(ViewPrecision, IsRobustForTheStandardScenes) {
  const TemporaryFolder folder;
  for (const char* const name : {"balls", "gears", "mount", "rings", "teapot", "tetra", "tree"}) {
    const SpdInfo& info = spd_info(name);
    const std::string path = folder.file("scene.nff");
    {
      const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "wb"), std::fclose);
      write_spd({info.scene, info.standard}, file.get(), path);
    }
    const Rendering rendering(read_nff(path), Store::automatic);
    FrameRequest request = rendering.request();
    for (const std::int32_t side : {512, 1024}) {
      request.camera.width = request.camera.height = side;
      const ViewPrecision chosen =
          view_precision(Tracer(rendering.scene(), &rendering.grid(), Device::cpu), request);
      EXPECT_EQ(chosen.precision, Precision::robust)
          << name << " of " << side << ": " << description_of(chosen);
    }
  }
}

} // namespace
} // namespace masu
