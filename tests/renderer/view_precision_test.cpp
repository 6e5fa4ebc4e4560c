// `--precision auto` follows the view: float32's errors are never seen, and double is hardly taken elsewhere.
#include "renderer/view_precision.h"

#include "libscene/nff/nff.h"
#include "tests/picture_scenes.h"
#include "tests/random_test.h"
#include "tests/rendering.h"
#include "tests/spd_text.h"

#include <fmt/format.h>

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
    const double reach = std::tan(15 * std::numbers::pi / 180), pixel = 2 * reach / 100 * distance;
    const double bound = rounding_margin<float>(rendering.scene().bounds()) / 4 +
                         0x1p-24 * (5 + 6 * std::sqrt(2.0) * reach) * distance;
    const ResidentTracer tracer = rendering.tracer();
    FrameRequest request = rendering.request();
    const ViewPrecision chosen = view_precision(tracer, request);
    if (std::abs(16 * bound / pixel - 1) < 1e-3) continue;
    EXPECT_EQ(chosen.precision, 16 * bound > pixel ? Precision::doubled : Precision::robust) << distance;
    EXPECT_EQ(view_precision(ResidentTracer(rendering.scene(), nullptr, Device::cpu), request).precision,
              chosen.precision);
    // The picture is the chosen one's, bit for bit, in parts as well.
    request.window = {10, 20, 30, 12};
    const Frame part = rendering.frame(request);
    request.tracing.precision = chosen.precision;
    expect_same_frames(rendering.frame(request), part);
  }
}

// Of each kind of error that pictures show: what is taken has no more pixels off than two in a thousand.
TEST_F(ViewPrecisions, PicturesOfFineThingsAreRight) {
  constexpr std::int32_t side = 128;
  const auto check = [&](const char* name, double parameter, const Scene& scene) {
    const Rendering rendering(scene, Store::float32);
    const Frame exact = picture(rendering, Precision::doubled);
    FrameRequest request = rendering.request();
    request.tracing.count = false;
    const ViewPrecision chosen = view_precision(rendering.tracer(), request);
    const double robust = pixels_off(picture(rendering, Precision::robust), exact);
    testing::Test::RecordProperty(fmt::format("{}_{:g}", name, parameter),
                                  fmt::format("robust {}, {}", robust, description_of(chosen)));
    EXPECT_TRUE(chosen.precision == Precision::doubled || robust <= 2e-3)
        << name << ' ' << parameter << ": " << robust << "; " << description_of(chosen);
    return chosen.precision;
  };
  for (const double distance : {1.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e9}) {
    const Precision chosen = check("afar", distance, seen_from_afar(chance_, distance, side));
    EXPECT_EQ(chosen, distance < 1e4 ? Precision::robust : Precision::doubled) << distance;
  }
  for (const double gap : {1e-3, 1e-5, 1e-6, 1e-7, 1e-8}) {
    check("stripes", gap, covered(chance_, gap, false, side));
    check("sheets", gap, covered(chance_, gap, true, side));
  }
  for (const double thickness : {1e-2, 1e-3, 1e-4, 1e-5})
    check("lens", thickness, thin_lens(chance_, thickness, side));
  for (const double length : {1e-1, 1e-2, 1e-3})
    check("needles", length, needles_on_floor(chance_, length, side, [](const Vec3d& aside) {
            return normalized(aside) * 0.005;
          }));
  for (const double radius : {1e-1, 1e-2, 1e-3, 4e-4})
    check("beads", radius, beads(chance_, radius, side));
  for (const double radius : {1e-3, 1e-4, 1e-5})
    check("hair", radius, hair(chance_, radius, side));
}

// Nothing is hidden from a light by what it lies on.
TEST_F(ViewPrecisions, ALightOnACeilingLightsTheRoom) {
  for (const Precision precision : {Precision::fast, Precision::robust, Precision::doubled}) {
    for (int i = 0; i < 4; ++i) {
      const auto [right, back, up] = tilted_axes(chance_);
      const Vec3d light = up * 2.0 + right * chance_.uniform(-0.5, 0.5) + back * chance_.uniform(-0.5, 0.5);
      Scene open = picture_scene(up * 1.5 - back * 1.5, {0, 0, 0}, light, 64);
      add_quad(open, {0, 0, 0}, right * 2.0, back * 2.0, picture_gray);
      add_sphere(open, up * 0.2, 0.2, mirror());
      Scene closed = open;
      add_quad(closed, up * 2.0, right * 2.0, back * 2.0, {{0, 0, 0}, 0, 0, 0, 0, 1});
      const Rendering without(open, Store::float32), with(closed, Store::float32);
      FrameRequest request = with.request();
      request.tracing.precision = precision;
      request.rules.depth = 1; // the mirror would see the ceiling
      EXPECT_EQ(pixels_off(with.frame(request), without.frame(request)), 0) << name_of(precision);
    }
  }
}

TEST_F(ViewPrecisions, SaysWhy) {
  const auto description = [&](const Scene& scene, Store store) {
    const Rendering rendering(scene, store);
    const ViewPrecision chosen = view_precision(rendering.tracer(), rendering.request());
    const std::string text = description_of(chosen);
    EXPECT_EQ(text.substr(0, text.find(':')), name_of(chosen.precision));
    return text;
  };
  const auto expect_begins = [](const std::string& text, const std::string& with) {
    EXPECT_EQ(text.substr(0, with.size()), with);
  };
  expect_begins(description(beads(chance_, 0.1, 64), Store::float32), "robust: float32's error");
  expect_begins(description(beads(chance_, 1e-4, 64), Store::float32), "double: float32's error");
  expect_begins(description(from_nearby(chance_, {0, 0, 0}, 4e-4, 128), Store::float64),
                "double: the scene is stored");
  expect_begins(description(empty_scene({0, 0, 1e-20}, {0, 0, 0}), Store::automatic), "robust: no surface");
  const std::string sampled = description(covered(chance_, 1e-7, true, 64), Store::float32);
  EXPECT_NE(sampled.find("sampled rays see other colours"), std::string::npos) << sampled;
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
