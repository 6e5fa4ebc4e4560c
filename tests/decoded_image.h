// Pictures read back: PNG by libpng, PFM by its definition.
#pragma once

#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <png.h>

namespace masu {

struct DecodedPng {
  std::size_t width = 0, height = 0;
  Bytes rgb; // top row first
};

// Empty where libpng finds anything wrong; a checksum is such a thing.
inline DecodedPng decoded_png(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) return {};
  EXPECT_EQ(png.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  png.format = PNG_FORMAT_RGB;
  DecodedPng decoded{png.width, png.height, Bytes(PNG_IMAGE_SIZE(png))};
  const bool good = png_image_finish_read(&png, nullptr, decoded.rgb.data(), 0, nullptr) != 0;
  EXPECT_TRUE(good && png.warning_or_error == 0) << png.message;
  return good ? decoded : DecodedPng{};
}

// A PFM's floats, top row first; empty where the file isn't of that size.
inline std::vector<float> decoded_pfm(const std::string& path, std::size_t width, std::size_t height,
                                      std::size_t channels = 3) {
  const std::string text = read_text(path);
  const std::string header = fmt::format("{}\n{} {}\n-1.0\n", channels == 3 ? "PF" : "Pf", width, height);
  const std::size_t row_bytes = channels * width * sizeof(float);
  if (!text.starts_with(header) || text.size() != header.size() + height * row_bytes) return {};
  std::vector<float> values(channels * width * height);
  for (std::size_t row = 0; row < height; ++row)
    std::memcpy(values.data() + row * channels * width,
                text.data() + header.size() + (height - 1 - row) * row_bytes, row_bytes);
  return values;
}

} // namespace masu
