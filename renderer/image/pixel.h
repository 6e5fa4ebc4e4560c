// A picture's pixels of the radiance that comes back along camera rays: the one definition for both backends.
#pragma once

#include "libscene/geometry/vector.h"
#include "renderer/camera.h"

#include <cmath>
#include <cstdint>

namespace masu {

// The pixel whose ray, or upper left corner, is *top; `columns` rays further on is the row below.
MASU_HD inline Vec3f pixel_at(const Vec3f* top, std::int32_t columns, Sampling sampling) {
  if (sampling != Sampling::corners) return *top;
  const Vec3f* const bottom = top + columns;
  return ((top[0] + top[1]) + (bottom[0] + bottom[1])) * 0.25F;
}

// Values above 1 are cut off, NaN is 0.
template <bool srgb>
MASU_HD inline std::uint8_t byte_of(float value) {
  float v = value > 0 ? (value < 1 ? value : 1.0F) : 0.0F;
  if constexpr (srgb) v = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
  const double above = static_cast<double>(v * 255) + 0.5;
  return static_cast<std::uint8_t>(static_cast<std::int32_t>(above)); // std::lround, but vectorized
}

} // namespace masu
