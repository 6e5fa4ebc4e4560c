// Pictures as JPEG, by libjpeg-turbo.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace masu {

// 100 is best. full_color: every pixel has a colour of its own (4:4:4), not every four (4:2:0).
struct JpegQuality {
  int quality = 92;
  bool full_color = true;
};

// `rgb` has 8 bits a channel, rows from the top. Throws Error(output).
std::string jpeg(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
                 const JpegQuality& quality);

} // namespace masu
