// How two pictures differ.
#pragma once

#include "tools/bench/picture_file.h"
#include "tools/draw/drawing.h"

#include <cstddef>

namespace masu {

struct Difference {
  std::int32_t width = 0, height = 0;
  double rmse = 0;           // over all numbers of all pixels
  double largest = 0;        // of a number
  std::int32_t x = 0, y = 0; // where, from the top left; the first of equals
  std::size_t different_pixels = 0;
  // Pixels in which a number is infinite or NaN in one picture, and not the same in the other; they count as
  // different, and in nothing else.
  std::size_t incomparable_pixels = 0;
  std::vector<double> pixels; // each one's largest difference; infinity for incomparable ones
};

// Throws Error(input, path, …) for pictures of different sizes or channels; `path` is b's.
Difference difference_of(const FloatPicture& a, const FloatPicture& b, const std::string& path);

Drawing difference_picture(const Difference& difference);

} // namespace masu
