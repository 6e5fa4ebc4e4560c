// `--precision auto` follows the view: float32's errors are never seen, and double is taken nowhere else.
#include "renderer/view_precision.h"

#include "libscene/nff/nff.h"
#include "tests/picture_scenes.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/spd_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace masu {
namespace {

using ViewPrecisions = RandomTest;

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

TEST_F(ViewPrecisions, PicturesOfSmallThingsAndOfThoseFarFromZeroAreRight) {
  expect_right("small", from_nearby(chance_, {0, 0, 0}, 4e-4, 128));
  expect_right("far", far_away(chance_, 1000, 128));
}

// A wall seen head-on, from nearer and nearer.
TEST_F(ViewPrecisions, IsDoubleWhereABoundIsMoreThanASixteenthOfAPixel) {
  for (double distance = 4; distance > 1e-6; distance /= 1.5) {
    Scene scene = empty_scene({0.25, 0, distance}, {0.25, 0, 0});
    scene.camera.angle = 30;
    scene.camera.width = scene.camera.height = 100;
    add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, matte({1, 1, 1}));
    add_sphere(scene, {0.25, 0, distance + 1}, 0.5, matte({1, 1, 1})); // behind the camera
    const Rendering rendering(scene, Store::float32);
    const double bound = rounding_margin<float>(rendering.scene().bounds()) / 4;
    const double pixel = 2 * std::tan(15 * std::numbers::pi / 180) / 100 * distance;
    const Tracer tracer = rendering.tracer();
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

TEST_F(ViewPrecisions, IsDoubleForAStoreOfDoublesAndRobustForNothing) {
  const Rendering stored(from_nearby(chance_, {0, 0, 0}, 4e-4, 128), Store::float64);
  const Tracer tracer = stored.tracer();
  EXPECT_EQ(view_precision(tracer, stored.request()).precision, Precision::doubled);
  EXPECT_TRUE(view_precision(tracer, stored.request()).is_stored);
  const Rendering nothing(empty_scene({0, 0, 1e-20}, {0, 0, 0}), Store::automatic);
  EXPECT_EQ(view_precision(nothing.tracer(), nothing.request()).precision, Precision::robust);
}

// As long as their errors can't be seen: doubled takes half as long again.
TEST_F(ViewPrecisions, IsRobustForTheStandardScenes) {
  for (const char* const name : {"balls", "gears", "mount", "rings", "teapot", "tetra", "tree"}) {
    const SpdInfo& info = spd_info(name);
    const Rendering rendering(parse_nff(spd_text({info.scene, info.standard}), name), Store::automatic);
    FrameRequest request = rendering.request();
    for (const std::int32_t side : {512, 1024}) {
      request.camera.width = request.camera.height = side;
      const ViewPrecision chosen = view_precision(rendering.tracer(), request);
      EXPECT_EQ(chosen.precision, Precision::robust)
          << name << " of " << side << ": " << description_of(chosen);
    }
  }
}

} // namespace
} // namespace masu
