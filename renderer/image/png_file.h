// 8-bit RGB pixels as a PNG file.
#pragma once

#include "libscene/file/output_file.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace masu {

// Keywords (1 to 79 characters) and texts, all ASCII.
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

// A piece of a raw deflate stream (RFC 1951). Pieces one after the other are one stream, which the last piece
// ends; they are compressed independently. The same bytes give the same piece. At most 1 GiB. Throws
// std::bad_alloc.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, bool last);

// A picture is compressed in bands of so many rows, which its width alone decides; the last one may be lower.
// Bands are independent: whoever encodes them, in whatever order, the file is the same.
std::int32_t png_band_rows(std::int32_t width);

// Rows of a picture as chunks of its file, and the checksum of what is compressed in them.
struct PngRows {
  std::int32_t rows = 0;
  std::uint32_t adler = 1;
  std::vector<std::uint8_t> chunks;
};

// Encodes whole bands by all threads: rows of three bytes per pixel. last: they end with the picture's last
// row, else their number is a multiple of png_band_rows().
PngRows encoded_rows(std::span<const std::uint8_t> rgb, std::int32_t width, bool last);

// What a file begins with.
std::vector<std::uint8_t> png_head(std::int32_t width, std::int32_t height, const PictureTexts& texts);

// Writes encoded rows one run after the other: memory depends on the runs, not on the picture.
class PngWriter {
public:
  // Both sides at least 1. The file must outlive the writer; it isn't committed. All throw Error(output).
  PngWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PictureTexts& texts = {});

  // The next rows from the top. The last of all rows completes the file.
  void write(const PngRows& rows);

private:
  OutputFile& file_;
  std::size_t row_bytes_; // of filtered rows
  std::int32_t rows_left_;
  std::uint32_t adler_ = 1; // of all rows written so far
};

// A whole picture. Throws Error(output).
void write_png(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
               const std::string& path, const PictureTexts& texts = {});

} // namespace masu
