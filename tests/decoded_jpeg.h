// JPEG pictures read back by libjpeg-turbo, and how far they are from what was encoded.
#pragma once

#include "tests/temporary_folder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>

namespace masu {

struct DecodedJpeg {
  std::int32_t width = 0, height = 0;
  Bytes rgb; // top row first
};

// Empty where libjpeg finds anything wrong, or has to guess.
inline DecodedJpeg decoded_jpeg(std::span<const std::uint8_t> bytes) {
  const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), tjDestroy);
  int width = 0, height = 0, sampling = 0, space = 0;
  if (tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &width, &height, &sampling, &space) != 0)
    return {};
  EXPECT_EQ(sampling, TJSAMP_444);
  DecodedJpeg decoded{width, height,
                      Bytes(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  const bool good = tjDecompress2(decoder.get(), bytes.data(), bytes.size(), decoded.rgb.data(), width, 0,
                                  height, TJPF_RGB, TJFLAG_ACCURATEDCT) == 0;
  EXPECT_TRUE(good) << tjGetErrorStr2(decoder.get());
  return good ? decoded : DecodedJpeg{};
}

// Peak signal-to-noise ratio. 0 where they aren't of one size.
inline double decibels(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
  if (a.size() != b.size()) return 0;
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    squares += (a[i] - b[i]) * (a[i] - b[i]);
  return 10 * std::log10(255 * 255 * static_cast<double>(a.size()) / std::max(squares, 1e-3));
}

// The comment; empty where there is none.
inline std::string jpeg_comment(std::span<const std::uint8_t> bytes) {
  for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at + 1] != 0xda;) { // up to the scan
    const std::size_t length = std::size_t{bytes[at + 2]} * 256 + bytes[at + 3];
    if (bytes[at + 1] == 0xfe)
      return std::string(reinterpret_cast<const char*>(bytes.data()) + at + 4, length - 2);
    at += 2 + length;
  }
  return {};
}

} // namespace masu
