// Colours of numbers: a perceptually uniform map from dark purple over blue and green to light yellow.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace masu {

struct Rgb8 {
  std::uint8_t r, g, b;
  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

// Lightness grows linearly, so that the map reads without colour too; hue turns evenly from 310° to 105°.
// Within Oklab (Ottosson 2020), where equal distances look alike.
inline Rgb8 color_at(double position) { // 0 to 1
  const double t = std::clamp(position, 0.0, 1.0), t2 = t * t;
  const double lightness = 0.25 + 0.67 * t, hue = (310 - 205 * t) * (3.14159265358979 / 180);
  const double chroma = 0.094 + 0.09 * t2 * t2; // within what sRGB can show
  const double a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b),
               m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b),
               s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const auto encoded = [](double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double value = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * value));
  };
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

// The map in 256 steps, computed once where many pixels are coloured.
struct ColorMap {
  std::array<Rgb8, 256> colors{};

  ColorMap() {
    for (std::size_t i = 0; i < colors.size(); ++i)
      colors[i] = color_at(static_cast<double>(i) / 255);
  }
  // Positions from 0 to 1; beyond them (and NaN) the ends.
  Rgb8 operator()(double position) const {
    return colors[position > 0 ? static_cast<std::size_t>(std::lround(255 * std::min(position, 1.0))) : 0];
  }
};

} // namespace masu
