// Pictures: made from frames of camera rays, written as PNG, JPEG or PFM.
#pragma once

#include "renderer/frame.h"
#include "renderer/image/png_file.h"

#include <string>
#include <vector>

namespace masu {

enum class ImageFormat { png, jpeg, pfm };

// By the file name's end, .png, .jpg, .jpeg or .pfm. Throws Error(usage, path, …) for another one.
ImageFormat image_format(const std::string& path);

struct ImageOptions {
  ImageFormat format = ImageFormat::png;
  Sampling sampling = Sampling::corners;
  bool srgb = false; // PNG, JPEG: encode values as sRGB; otherwise they are stored as they are
  PictureTexts texts{};
  int quality = 0; // of a JPEG
};

// A frame's pixels as files have them, each the mean of its four corners, or its centre. rgb_rows: 8 bits per
// channel, values above 1 are cut off; pfm_rows: 32-bit floats, from the bottom row up, to follow pfm_head()
// and what lies below the frame.
std::vector<std::uint8_t> rgb_rows(const Frame& frame, Sampling sampling, bool srgb);
std::vector<std::uint8_t> pfm_rows(const Frame& frame, Sampling sampling);
std::string pfm_head(std::int32_t width, std::int32_t height);

} // namespace masu
