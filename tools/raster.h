// A picture in memory to draw into: rectangles, pixels, text.
#pragma once

#include "tools/color_map.h"
#include "tools/pixel_font.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace masu {

class Raster {
public:
  static constexpr Rgb white{255, 255, 255}, black{0, 0, 0};

  Raster(std::int32_t width, std::int32_t height)
      : width_(width), height_(height),
        rgb_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255) {}

  std::int32_t width() const { return width_; }
  std::int32_t height() const { return height_; }
  const std::vector<std::uint8_t>& rgb() const { return rgb_; }

  // What lies outside is left out.
  void fill(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height, const Rgb& color) {
    for (std::int32_t row = std::max(y, 0); row < std::min(y + height, height_); ++row)
      for (std::int32_t column = std::max(x, 0); column < std::min(x + width, width_); ++column)
        std::copy(color.begin(), color.end(), rgb_.begin() + 3 * (std::ptrdiff_t{row} * width_ + column));
  }

  // (x, y): the top left corner; a pixel of the font is a square of so many.
  void text(std::int32_t x, std::int32_t y, std::int32_t size, std::string_view line) {
    for (const char c : line) {
      for (int v = 0; v < glyph_height; ++v)
        for (int u = 0; u < glyph_width; ++u)
          if (is_ink(c, u, v)) fill(x + u * size, y + v * size, size, size, black);
      x += advance * size;
    }
  }
  static constexpr std::int32_t advance = glyph_width + 1; // of a character, in pixels of the font

private:
  std::int32_t width_, height_;
  std::vector<std::uint8_t> rgb_;
};

} // namespace masu
