// Pictures: made from the layout of eye rays, written as PNG or PFM.
#pragma once

#include "renderer/tracer.h"

#include <string>
#include <vector>

namespace masu {

// Linear colour, row by row from the top.
struct Image {
  std::int32_t width, height;
  std::vector<Vec3f> pixels;
};

// Each pixel the mean of its four corners, or its centre.
Image image_of(const Frame& frame, Sampling sampling);

// By the file name's end: .png (8 bits a channel; values stored as they are, or sRGB-encoded; above 1 they
// are cut off) or .pfm (32-bit floats). Throws Error(usage) for another end, Error(output).
void write_image(const Image& image, const std::string& path, bool srgb);

// Whether write_image knows the file name's end. Throws Error(usage, path, …) if not.
void check_image_name(const std::string& path);

} // namespace masu
