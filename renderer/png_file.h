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
using PngTexts = std::vector<std::pair<std::string, std::string>>;

// Writes a picture run of rows by run of rows: memory depends on the runs, not on the picture. Rows are
// compressed by all threads in bands whose size depends on the picture's width alone, so that the file
// depends neither on the number of threads nor on the runs.
class PngWriter {
public:
  // Both sides at least 1. The file must outlive the writer; it isn't committed. All throw Error(output).
  PngWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PngTexts& texts = {});

  // The next rows from the top, three bytes a pixel. The last of all rows completes the file.
  void write_rows(std::span<const std::uint8_t> rgb);

private:
  void write_chunk(const char* type, std::span<const std::uint8_t> data);
  void write_bands(std::size_t rows);

  OutputFile& file_;
  std::size_t row_bytes_, band_rows_, rows_left_; // rows_left_: to be compressed
  std::vector<std::uint8_t> above_;               // the last row given; zeros at first
  std::vector<std::uint8_t> filtered_;            // rows that aren't compressed yet, a byte more each
  std::uint32_t adler_ = 1;                       // of all filtered rows compressed so far
};

// A whole picture. Throws Error(output).
void write_png(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
               const std::string& path, const PngTexts& texts = {});

} // namespace masu
