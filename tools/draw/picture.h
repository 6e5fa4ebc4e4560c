// 8-bit RGB pixels in memory, to draw charts and labels on.
#pragma once

#include "tools/draw/color_map.h"

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

  Picture(std::int32_t columns, std::int32_t rows, Rgb background = {255, 255, 255})
      : width(columns), height(rows) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgb.reserve(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
      rgb.insert(rgb.end(), {background[0], background[1], background[2]});
  }

  // Mixes the colour over a pixel by `share`, from 0 (nothing) to 1. Beyond the picture nothing is drawn.
  void blend(std::int32_t x, std::int32_t y, Rgb color, double share = 1) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    std::uint8_t* const at = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                       static_cast<std::size_t>(x))];
    const auto mixed = [share](std::uint8_t below, std::uint8_t above) {
      return static_cast<std::uint8_t>(std::lround(below + share * (above - below)));
    };
    at[0] = mixed(at[0], color[0]);
    at[1] = mixed(at[1], color[1]);
    at[2] = mixed(at[2], color[2]);
  }

  // Pixels from (x, y) up to, not including, (x + columns, y + rows).
  void fill(std::int32_t x, std::int32_t y, std::int32_t columns, std::int32_t rows, Rgb color) {
    for (std::int32_t v = std::max(y, 0); v < std::min(y + rows, height); ++v) {
      for (std::int32_t u = std::max(x, 0); u < std::min(x + columns, width); ++u)
        blend(u, v, color);
    }
  }
};

} // namespace masu
