// The colour map of pictures.
#include "tools/common/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace masu {
namespace {

double luminance(Rgb color) {
  const auto linear = [](std::uint8_t value) {
    const double x = value / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

// CIE 1976 lightness.
double lightness(Rgb color) {
  const double y = luminance(color);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMap, LightnessGrowsEvenlySoThatItReadsWithoutColor) {
  const ColorMap map;
  const double low = lightness(map(0)), high = lightness(map(1));
  EXPECT_LT(low, 20);
  EXPECT_GT(high, 85);
  for (int i = 0; i <= 100; ++i) {
    const double at = i / 100.0, step = lightness(map(at)) - lightness(map(at - 0.01));
    EXPECT_NEAR(lightness(map(at)), low + at * (high - low), 0.05 * (high - low)) << at;
    if (i == 0) continue;
    EXPECT_GT(step, 0.2) << at;
    EXPECT_LT(step, 1.8) << at;
  }
}

TEST(ColorMap, ValuesBeyondItsEndsHaveTheEndsColors) {
  const ColorMap map;
  EXPECT_EQ(map(-1), map(0));
  EXPECT_EQ(map(2), map(1));
  EXPECT_EQ(map(std::numeric_limits<double>::infinity()), map(1));
  EXPECT_EQ(map(std::numeric_limits<double>::quiet_NaN()), map(0));
}

} // namespace
} // namespace masu
