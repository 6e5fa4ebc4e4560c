// The colour map and text of pictures.
#include "tools/draw/bitmap_text.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

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

std::string pixels_of(const Picture& picture) {
  return {picture.rgb.begin(), picture.rgb.end()};
}

bool is_dark(const Picture& picture, std::int32_t x, std::int32_t y) {
  return picture.rgb[3 * static_cast<std::size_t>(y * picture.width + x)] == 0;
}

TEST(ColorMap, LightnessGrowsEvenlySoThatItReadsWithoutColor) {
  const ColorMap map;
  const double low = lightness(map(0)), high = lightness(map(1));
  EXPECT_LT(low, 20);
  EXPECT_GT(high, 85);
  for (int i = 0; i <= 32; ++i) {
    const double at = i / 32.0;
    EXPECT_NEAR(lightness(map(at)), low + at * (high - low), 0.05 * (high - low)) << at;
    if (i > 0) {
      EXPECT_GT(lightness(map(at)), lightness(map((i - 1) / 32.0)));
    }
  }
}

TEST(ColorMap, ValuesBeyondItsEndsHaveTheEndsColors) {
  const ColorMap map;
  EXPECT_EQ(map(-1), map(0));
  EXPECT_EQ(map(2), map(1));
  EXPECT_EQ(map(std::numeric_limits<double>::infinity()), map(1));
  EXPECT_EQ(map(std::numeric_limits<double>::quiet_NaN()), map(0));
}

TEST(BitmapText, EachCharacterHasItsOwnGlyph) {
  std::set<std::string> seen;
  for (int code = ' '; code <= '~' + 1; ++code) {
    Picture picture(text_advance, text_height + text_descent);
    draw_text(picture, 0, 0, std::string(1, static_cast<char>(code)));
    EXPECT_TRUE(seen.insert(pixels_of(picture)).second) << code;
  }
}

TEST(BitmapText, StaysWithinItsWidthAndHeight) {
  const std::string text = "gQ@|~_j, 09";
  for (const std::int32_t scale : {1, 3}) {
    const std::int32_t width = text_width(text, scale), height = (text_height + text_descent) * scale;
    Picture picture(width + 20, height + 20);
    draw_text(picture, 10, 10, text, {0, 0, 0}, scale);
    for (std::int32_t y = 0; y < picture.height; ++y) {
      for (std::int32_t x = 0; x < picture.width; ++x) {
        if (x < 10 || y < 10 || x >= 10 + width || y >= 10 + height) {
          EXPECT_FALSE(is_dark(picture, x, y)) << x << ' ' << y;
        }
      }
    }
  }
}

TEST(BitmapText, UpwardsIsTurnedLeft) {
  constexpr std::int32_t size = 60;
  Picture right(size, size), up(size, size);
  draw_text(right, 7, 5, "xyz 1.5", {0, 0, 0}, 1);
  draw_text(up, 5, size - 1 - 7, "xyz 1.5", {0, 0, 0}, 1, TextDirection::up);
  for (std::int32_t y = 0; y < size; ++y) {
    for (std::int32_t x = 0; x < size; ++x)
      ASSERT_EQ(is_dark(right, x, y), is_dark(up, y, size - 1 - x)) << x << ' ' << y;
  }
}

TEST(BitmapText, BeyondThePictureNothingIsDrawn) {
  Picture picture(8, 8);
  draw_text(picture, -20, -3, "beyond every side", {0, 0, 0}, 4);
  draw_text(picture, 5, 30, "beyond every side", {0, 0, 0}, 2, TextDirection::up);
  EXPECT_EQ(picture.rgb.size(), 8U * 8 * 3);
}

} // namespace
} // namespace masu
