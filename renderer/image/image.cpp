#include "renderer/image/image.h"

#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "renderer/image/pixel.h"

#include <fmt/format.h>

#include <cstring>
#include <string_view>

namespace masu {
namespace {

constexpr std::int32_t rows_per_task = 16;

// Of so many bytes per pixel: convert(row, its pixels, all of the picture's bytes), in parallel.
template <class Convert>
std::vector<std::uint8_t> bytes_of(const Frame& frame, Sampling sampling, std::size_t pixel_bytes,
                                   const Convert& convert) {
  const std::int32_t more = rays_beyond_pixels(sampling), width = frame.columns - more,
                     height = frame.rows - more;
  std::vector<std::uint8_t> bytes(pixel_bytes * static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
  parallel_ranges(static_cast<std::uint64_t>(height), rows_per_task, [&](std::size_t begin, std::size_t end) {
    std::vector<Vec3f> pixels(static_cast<std::size_t>(width));
    for (std::size_t row = begin; row != end; ++row) {
      const Vec3f* const top = frame.radiance.data() + row * static_cast<std::size_t>(frame.columns);
      for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = pixel_at(top + i, frame.columns, sampling);
      convert(row, pixels, bytes.data());
    }
  });
  return bytes;
}

template <bool srgb>
std::vector<std::uint8_t> rgb_of(const Frame& frame, Sampling sampling) {
  return bytes_of(frame, sampling, 3,
                  [](std::size_t row, const std::vector<Vec3f>& pixels, std::uint8_t* all) {
                    std::uint8_t* bytes = all + row * 3 * pixels.size();
                    for (const Vec3f& pixel : pixels) {
                      *bytes++ = byte_of<srgb>(pixel.x);
                      *bytes++ = byte_of<srgb>(pixel.y);
                      *bytes++ = byte_of<srgb>(pixel.z);
                    }
                  });
}

} // namespace

ImageFormat image_format(const std::string& path) {
  const std::string_view name = path;
  if (name.ends_with(".png")) return ImageFormat::png;
  if (name.ends_with(".jpg") || name.ends_with(".jpeg")) return ImageFormat::jpeg;
  if (name.ends_with(".pfm")) return ImageFormat::pfm;
  throw Error(ErrorCode::usage, path, "pictures are PNG, JPEG or PFM: name it .png, .jpg or .pfm");
}

std::vector<std::uint8_t> rgb_rows(const Frame& frame, Sampling sampling, bool srgb) {
  if (!frame.rgb.empty()) return {frame.rgb.begin(), frame.rgb.end()};
  return srgb ? rgb_of<true>(frame, sampling) : rgb_of<false>(frame, sampling);
}

std::vector<std::uint8_t> pfm_rows(const Frame& frame, Sampling sampling) {
  const auto last = static_cast<std::size_t>(frame.rows - rays_beyond_pixels(sampling)) - 1;
  return bytes_of(frame, sampling, sizeof(Vec3f),
                  [&](std::size_t row, const std::vector<Vec3f>& pixels, std::uint8_t* all) {
                    const std::size_t row_bytes = pixels.size() * sizeof(Vec3f);
                    std::memcpy(all + (last - row) * row_bytes, pixels.data(), row_bytes);
                  });
}

std::string pfm_head(std::int32_t width, std::int32_t height) {
  return fmt::format("PF\n{} {}\n-1.0\n", width, height); // -1: little-endian
}

} // namespace masu
