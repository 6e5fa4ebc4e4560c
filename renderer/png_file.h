// 8-bit RGB pixels as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace masu {

// Three bytes a pixel, row by row from the top. Throws Error(output).
void write_png(const std::vector<std::uint8_t>& rgb, std::int32_t width, std::int32_t height,
               const std::string& path);

} // namespace masu
