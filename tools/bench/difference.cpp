#include "tools/bench/difference.h"

#include "libscene/base/error.h"
#include "tools/draw/value_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace masu {

Difference difference_of(const FloatPicture& a, const FloatPicture& b, const std::string& path) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels)
    throw Error(
        ErrorCode::input, path,
        fmt::format("has {} x {} pixels of {} channels, the other picture {} x {} of {}: give pictures "
                    "of one size",
                    b.width, b.height, b.channels, a.width, a.height, a.channels));
  Difference result;
  result.width = a.width;
  result.height = a.height;
  const auto channels = static_cast<std::size_t>(a.channels);
  const std::size_t pixels = a.values.size() / channels;
  result.pixels.resize(pixels);
  double squares = 0;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double largest = 0;
    bool comparable = true;
    for (std::size_t k = i * channels; k < (i + 1) * channels; ++k) {
      const double one = static_cast<double>(a.values[k]), other = static_cast<double>(b.values[k]);
      const bool same = one == other || (std::isnan(one) && std::isnan(other)); // infinities too
      if (!same && !(std::isfinite(one) && std::isfinite(other))) {
        comparable = false;
        continue;
      }
      const double difference = same ? 0 : std::abs(one - other);
      largest = std::fmax(largest, difference);
      squares += difference * difference;
      ++compared;
    }
    result.pixels[i] = comparable ? largest : std::numeric_limits<double>::infinity();
    result.different_pixels += largest > 0 || !comparable;
    result.incomparable_pixels += !comparable;
    if (largest > result.largest) {
      result.largest = largest;
      result.x = static_cast<std::int32_t>(i % static_cast<std::size_t>(a.width));
      result.y = static_cast<std::int32_t>(i / static_cast<std::size_t>(a.width));
    }
  }
  if (compared > 0) result.rmse = std::sqrt(squares / static_cast<double>(compared));
  return result;
}

Drawing difference_picture(const Difference& difference) {
  Caption caption;
  caption.title = fmt::format("difference: the largest of each pixel; rmse {:.4g}, {} of {} pixels differ",
                              difference.rmse, difference.different_pixels, difference.pixels.size());
  caption.unit = "absolute difference";
  caption.without = "infinite in one picture only";
  caption.values = Caption::Values::from_zero;
  return value_picture({difference.width, difference.height, difference.pixels}, caption);
}

} // namespace masu
