// The numbers of rays of each kind for the SPD scenes are those published.
//
// Sources: the SPD's own documentation ("should be within about 10%"), and V. Havran & J. Sixta, "Comparison
// of Hierarchical Grids", Ray Tracing News 12(1), 1999, for a second count of camera rays' hits.
#include "tests/tools/run_tool.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace masu {
namespace {

// For 513×513 corner rays, depth 5, and the SPD's rules.
struct Published {
  const char* scene;
  double objects;
  double camera_hits, eye_hits_of_1999;
  double reflection_rays, refraction_rays, shadow_rays;
};

constexpr std::array<Published, 7> published{{
    {"balls", 7382, 263169, 263169, 175095, 0, 954368},
    {"gears", 9345, 245086, 245332, 304643, 207564, 2246955},
    {"mount", 8196, 173125, 173685, 354769, 354769, 412922},
    {"rings", 8401, 263169, 263169, 315236, 0, 1085002},
    {"teapot", 9264, 161120, 161546, 225248, 0, 407656},
    {"tetra", 4096, 49788, 49950, 0, 0, 46112},
    {"tree", 8191, 169836, 169907, 0, 0, 1097419},
}};

void PrintTo(const Published& counts, std::ostream* out) {
  *out << counts.scene;
}

class SpdCounts : public ToolTest, public testing::WithParamInterface<Published> {};

testing::AssertionResult is_within(double share, double counted, double expected) {
  if (std::abs(counted - expected) <= share * expected) return testing::AssertionSuccess();
  return testing::AssertionFailure() << counted << " is " << 100 * (counted / expected - 1) << " % off "
                                     << expected;
}

TEST_P(SpdCounts, EqualThePublishedOnes) {
  const Published& expected = GetParam();
  const std::string text = spd("a.nff", expected.scene);
  const std::string scene_path = scene("a.scene", text);
  EXPECT_EQ(json_of("nff2bin", {scene_path, "--info"})["objects"]["total"], expected.objects);

  grid("a.grid", scene_path);
  expect_runs("gridrender ~/a.scene ~/a.grid --backend cpu --spd-rules --stats ~/stats.json");
  const auto counted = json_in("stats.json");
  ASSERT_FALSE(counted.is_discarded());
  const auto count = [&](const char* name) { return counted[name].get<double>(); };
  EXPECT_EQ(count("eye_rays"), 513 * 513);
  EXPECT_TRUE(is_within(0.001, count("eye_hits"), expected.camera_hits) ||
              is_within(0.001, count("eye_hits"), expected.eye_hits_of_1999))
      << count("eye_hits") << " eye hits";
  EXPECT_TRUE(is_within(0.01, count("reflection_rays"), expected.reflection_rays));
  const double for_refraction = std::string(expected.scene) == "gears" ? 0.04 : 0.01;
  EXPECT_TRUE(is_within(for_refraction, count("refraction_rays"), expected.refraction_rays));
  EXPECT_TRUE(is_within(0.01, count("shadow_rays"), expected.shadow_rays));
}

INSTANTIATE_TEST_SUITE_P(All, SpdCounts, testing::ValuesIn(published),
                         [](const auto& test) { return std::string(test.param.scene); });

} // namespace
} // namespace masu
