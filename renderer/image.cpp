#include "renderer/image.h"

#include "libscene/error.h"
#include "libscene/file/output_file.h"
#include "renderer/png_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

bool ends_with(const std::string& path, const char* end) {
  return std::string_view(path).ends_with(end);
}

std::uint8_t byte_of(float value, bool srgb) {
  const float held = value > 0 ? std::min(value, 1.0F) : 0.0F; // NaN becomes 0
  const float encoded = !srgb                ? held
                        : held <= 0.0031308F ? 12.92F * held
                                             : 1.055F * std::pow(held, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(encoded * 255));
}

void write_pfm(const Image& image, const std::string& path) {
  OutputFile file(path);
  const std::string head = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height); // -1: little-endian
  file.write(head.data(), head.size());
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t row = static_cast<std::size_t>(image.height); row-- > 0;) { // from the bottom up
    file.write(image.pixels.data() + row * width, width * sizeof(Vec3f));
  }
  file.commit();
}

} // namespace

Image image_of(const Frame& frame, Sampling sampling) {
  if (sampling == Sampling::centers) return {frame.columns, frame.rows, frame.radiance};
  Image image{frame.columns - 1, frame.rows - 1, {}};
  image.pixels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const auto columns = static_cast<std::size_t>(frame.columns);
  for (std::size_t row = 0; row + 1 < static_cast<std::size_t>(frame.rows); ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const Vec3f* const top = frame.radiance.data() + row * columns + column;
      image.pixels.push_back(((top[0] + top[1]) + (top[columns] + top[columns + 1])) * 0.25F);
    }
  }
  return image;
}

void check_image_name(const std::string& path) {
  if (!ends_with(path, ".png") && !ends_with(path, ".pfm")) {
    throw Error(ErrorCode::usage, path, "isn't a kind of picture this program writes: name it .png or .pfm");
  }
}

void write_image(const Image& image, const std::string& path, bool srgb) {
  check_image_name(path);
  if (ends_with(path, ".pfm")) return write_pfm(image, path);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.pixels.size() * 3);
  for (const Vec3f& pixel : image.pixels) {
    for (int channel = 0; channel < 3; ++channel)
      rgb.push_back(byte_of(pixel[channel], srgb));
  }
  write_png(rgb, image.width, image.height, path);
}

} // namespace masu
