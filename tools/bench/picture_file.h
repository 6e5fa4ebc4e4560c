// Reads pictures and channels: PNG, PFM and NumPy arrays.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace masu {

// Row by row from the top, `channels` numbers a pixel.
struct FloatPicture {
  std::int32_t width = 0, height = 0, channels = 0; // 1 or 3
  std::vector<float> values;                        // of a PNG its bytes / 255
};

// Known by its content. An array has the shape (rows, columns) or (rows, columns, 3) and numbers of type <f4,
// <i4 or <u4. Throws Error(input, path, …) for what isn't such a file, or is damaged.
FloatPicture read_picture(const std::string& path);

} // namespace masu
