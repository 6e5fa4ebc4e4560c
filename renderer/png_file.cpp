#include "renderer/png_file.h"

#include "renderer/deflate.h"

#include <libdeflate.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace masu {
namespace {

constexpr std::size_t channels = 3, rows_a_task = 16;
// Joining bands costs a third of the compression's time: a picture of 1024×1024 is one band.
constexpr std::size_t band_bytes = std::size_t{4} << 20;

void put(std::vector<std::uint8_t>& bytes, std::uint32_t value) { // big-endian
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

// The Paeth predictor (PNG specification, 9.4) of every row. Choosing a predictor for each row, as libpng
// does by default, made rendered pictures no smaller.
void filter(const std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::uint8_t* filtered) {
  constexpr std::uint8_t paeth = 4;
  *filtered++ = paeth;
  for (std::size_t i = 0; i < std::min(channels, bytes); ++i)
    filtered[i] = static_cast<std::uint8_t>(row[i] - above[i]);
  for (std::size_t i = channels; i < bytes; ++i) {
    const std::int16_t a = row[i - channels], b = above[i], c = above[i - channels];
    const auto from_a = static_cast<std::int16_t>(std::abs(b - c)),
               from_b = static_cast<std::int16_t>(std::abs(a - c)),
               from_c = static_cast<std::int16_t>(std::abs(a + b - 2 * c));
    const std::int16_t nearest = from_a <= from_b && from_a <= from_c ? a : from_b <= from_c ? b : c;
    filtered[i] = static_cast<std::uint8_t>(row[i] - nearest);
  }
}

struct Band {
  std::vector<std::uint8_t> stream;
  std::uint32_t adler = 1;
  std::size_t bytes = 0; // before compression
};

} // namespace

PngWriter::PngWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PngTexts& texts)
    : file_(file), row_bytes_(channels * static_cast<std::size_t>(width)),
      band_rows_(std::max<std::size_t>(band_bytes / (row_bytes_ + 1), 1)),
      rows_left_(static_cast<std::size_t>(height)), above_(row_bytes_) {
  constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  file_.write(signature);
  std::vector<std::uint8_t> header;
  put(header, static_cast<std::uint32_t>(width));
  put(header, static_cast<std::uint32_t>(height));
  header.insert(header.end(),
                {8, 2, 0, 0, 0}); // bits a channel; RGB; deflate; adaptive filters; not interlaced
  write_chunk("IHDR", header);
  for (const auto& [keyword, text] : texts) {
    std::vector<std::uint8_t> data(keyword.begin(), keyword.end());
    data.push_back(0);
    data.insert(data.end(), text.begin(), text.end());
    write_chunk("tEXt", data);
  }
  write_chunk("IDAT", std::array<std::uint8_t, 2>{0x78, 0x5e}); // zlib's header: a window of 32 KiB
}

void PngWriter::write_chunk(const char* type, std::span<const std::uint8_t> data) {
  std::vector<std::uint8_t> head, tail;
  put(head, static_cast<std::uint32_t>(data.size()));
  head.insert(head.end(), type, type + 4);
  std::uint32_t sum = libdeflate_crc32(0, type, 4);
  if (!data.empty()) sum = libdeflate_crc32(sum, data.data(), data.size()); // of a null pointer it is 0
  put(tail, sum);
  file_.write(head);
  file_.write(data);
  file_.write(tail);
}

void PngWriter::write_rows(std::span<const std::uint8_t> rgb) {
  const std::size_t rows = rgb.size() / row_bytes_, before = filtered_.size();
  if (rows == 0) return;
  filtered_.resize(before + rows * (row_bytes_ + 1));
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows, rows_a_task), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const std::uint8_t* const row = rgb.data() + i * row_bytes_;
      filter(row, i == 0 ? above_.data() : row - row_bytes_, row_bytes_,
             filtered_.data() + before + i * (row_bytes_ + 1));
    }
  });
  const auto last = rgb.subspan((rows - 1) * row_bytes_, row_bytes_);
  above_.assign(last.begin(), last.end());
  const std::size_t waiting = filtered_.size() / (row_bytes_ + 1);
  if (waiting >= band_rows_ || waiting == rows_left_) write_bands(waiting);
}

// Compresses and writes all whole bands of so many rows, and the picture's last one.
void PngWriter::write_bands(std::size_t rows) {
  const bool ends = rows == rows_left_;
  std::vector<Band> bands((ends ? rows + band_rows_ - 1 : rows) / band_rows_);
  const std::size_t used = ends ? rows : bands.size() * band_rows_;
  tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t i) {
    const std::size_t first = i * band_rows_, count = std::min(band_rows_, used - first);
    const auto bytes = std::span(filtered_).subspan(first * (row_bytes_ + 1), count * (row_bytes_ + 1));
    bands[i] = {deflated(bytes, ends && i + 1 == bands.size()),
                libdeflate_adler32(1, bytes.data(), bytes.size()), bytes.size()};
  });
  for (const Band& band : bands) {
    write_chunk("IDAT", band.stream);
    adler_ =
        static_cast<std::uint32_t>(adler32_combine(adler_, band.adler, static_cast<z_off_t>(band.bytes)));
  }
  filtered_.erase(filtered_.begin(),
                  filtered_.begin() + static_cast<std::ptrdiff_t>(used * (row_bytes_ + 1)));
  rows_left_ -= used;
  if (rows_left_ > 0) return;
  std::vector<std::uint8_t> end;
  put(end, adler_);
  write_chunk("IDAT", end);
  write_chunk("IEND", {});
}

void write_png(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
               const std::string& path, const PngTexts& texts) {
  OutputFile file(path);
  PngWriter(file, width, height, texts).write_rows(rgb);
  file.commit();
}

} // namespace masu
