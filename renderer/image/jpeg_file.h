// 8-bit RGB pixels as JPEG, by libjpeg-turbo; and JPEG files of bands that were encoded independently.
#pragma once

#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"

#include <cstdint>
#include <span>
#include <vector>

namespace masu {

// 100 is best. full_color: every pixel has a colour of its own (4:4:4), not every four (4:2:0).
struct JpegQuality {
  int quality = 92;
  bool full_color = true;
};

inline constexpr std::int32_t largest_jpeg_side = 65500; // that libjpeg writes and reads

// A whole picture, rows from the top. Throws Error(output), Error(usage) where the build found no
// libjpeg-turbo.
std::vector<std::uint8_t> jpeg(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
                               const JpegQuality& quality);
bool has_libjpeg();

// A picture in full color is encoded in bands of so many rows, which its width alone decides; the last one
// may be lower. Bands are independent: restart markers separate them, so the decoder begins anew with each.
std::int32_t jpeg_band_rows(std::int32_t width);

// The segment of a file that has its texts.
std::vector<std::uint8_t> jpeg_comment(const PictureTexts& texts);

// Makes a file of bands' pictures, one after the other.
class JpegWriter {
public:
  // Of the whole picture; both sides are from 1 to largest_jpeg_side. `texts` become a comment. The file must
  // outlive the writer; it isn't committed. All throw Error(output).
  JpegWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PictureTexts& texts = {});

  // The next band from the top, as jpeg() made it: all of one quality. The last one completes the file.
  void write(std::span<const std::uint8_t> band);

private:
  OutputFile& file_;
  std::int32_t width_, height_, band_ = 0;   // band_: the next one
  std::vector<std::uint8_t> comment_, head_; // head_: of the first band, which all others' are like
};

} // namespace masu
