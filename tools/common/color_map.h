// Colours of values and of categories, in steps that look equally large: computed in OKLab (Ottosson, "A
// perceptual color space for image processing", 2020); and of normals.
#pragma once

#include "libscene/geometry/vector.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace masu {

using Rgb = std::array<std::uint8_t, 3>; // sRGB

// Lightness and chroma of OKLab, hue in degrees; linear sRGB, which may lie out of its gamut.
inline std::array<double, 3> linear_srgb(double lightness, double chroma, double hue) {
  const double angle = hue * std::numbers::pi / 180;
  const double a = chroma * std::cos(angle), b = chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b),
               m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b),
               s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

// The colour of that lightness and hue with that chroma, or with as much as sRGB has.
inline Rgb color_of(double lightness, double chroma, double hue) {
  const auto fits = [&](double c) {
    for (const double channel : linear_srgb(lightness, c, hue))
      if (channel < 0 || channel > 1) return false;
    return true;
  };
  double least = 0, most = chroma;
  if (!fits(chroma)) {
    for (int i = 0; i < 20; ++i)
      (fits((least + most) / 2) ? least : most) = (least + most) / 2;
    most = least;
  }
  Rgb rgb{};
  const std::array<double, 3> linear = linear_srgb(lightness, most, hue);
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = std::fmin(std::fmax(linear[i], 0), 1);
    rgb[i] = static_cast<std::uint8_t>(
        std::lround(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055)));
  }
  return rgb;
}

// From dark to light: lightness rises evenly, so that order can be seen without colour.
class ColorMap {
public:
  // What a ray takes, and depth: from violet by green to yellow. Chroma stays below what sRGB has of each
  // hue, or a kink would look like an edge.
  ColorMap()
      : ColorMap([](double t) {
          return color_of(0.2 + 0.74 * t, 0.09 + 0.25 * (t - 0.42) * (t - 0.42), 300 - 195 * t);
        }) {}
  // Lists of cells and boxes: violet alone, so that none of their colours means anything else beside a ray's
  // walk.
  static ColorMap of_lists() {
    return ColorMap([](double t) { return color_of(0.2 + 0.68 * t, 0.19 - 0.11 * t, 300); });
  }
  // t from 0 to 1; others as the nearer end.
  const Rgb& operator()(double t) const {
    return colors_[static_cast<std::size_t>(std::lround(std::fmin(std::fmax(t, 0), 1) * (size - 1)))];
  }

private:
  explicit ColorMap(Rgb (*color)(double t)) {
    for (std::size_t i = 0; i < size; ++i)
      colors_[i] = color(static_cast<double>(i) / (size - 1));
  }

  static constexpr std::size_t size = 1024;
  std::array<Rgb, size> colors_{};
};

// Category k of any number: the first dozen are easily told apart, also by lightness.
inline Rgb category_color(std::size_t k) {
  constexpr double lightness[] = {0.62, 0.82, 0.45, 0.72};
  return color_of(lightness[k % 4], 0.13, std::fmod(30 + 137.508 * static_cast<double>(k), 360));
}

// A unit vector n as (n + 1) / 2 in red, green, blue.
inline Rgb normal_color(const Vec3f& n) {
  const auto channel = [](float v) {
    return static_cast<std::uint8_t>(std::lround(127.5F * (1 + std::fmin(std::fmax(v, -1.0F), 1.0F))));
  };
  return {channel(n.x), channel(n.y), channel(n.z)};
}

} // namespace masu
