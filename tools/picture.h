// 8-bit RGB pixels in memory, to draw charts and labels on.
#pragma once

#include "tools/color_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace masu {

// Rows from the top, three bytes a pixel: what write_png takes.
struct Picture {
  std::int32_t width, height;
  std::vector<std::uint8_t> rgb;

  Picture(std::int32_t columns, std::int32_t rows, Rgb8 background = {255, 255, 255})
      : width(columns), height(rows) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgb.reserve(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
      rgb.insert(rgb.end(), {background.r, background.g, background.b});
  }

  // Mixes the colour over a pixel by `share`, from 0 (nothing) to 1. Beyond the picture nothing is drawn.
  void blend(std::int32_t x, std::int32_t y, Rgb8 color, double share = 1) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    std::uint8_t* const at = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(x))];
    const auto mixed = [share](std::uint8_t below, std::uint8_t above) {
      return static_cast<std::uint8_t>(std::lround(below + share * (above - below)));
    };
    at[0] = mixed(at[0], color.r);
    at[1] = mixed(at[1], color.g);
    at[2] = mixed(at[2], color.b);
  }

  // Pixels from (x, y) up to, not including, (x + columns, y + rows).
  void fill(std::int32_t x, std::int32_t y, std::int32_t columns, std::int32_t rows, Rgb8 color) {
    for (std::int32_t v = std::max(y, 0); v < std::min(y + rows, height); ++v) {
      for (std::int32_t u = std::max(x, 0); u < std::min(x + columns, width); ++u)
        blend(u, v, color);
    }
  }
};

} // namespace masu
