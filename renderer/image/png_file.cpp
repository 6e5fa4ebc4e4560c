#include "renderer/image/png_file.h"

#include "libscene/base/parallel.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace masu {
namespace {

constexpr std::size_t channels = 3;
// They stay in a core's cache: of 1024×1024 pixels are six bands.
constexpr std::size_t band_bytes = std::size_t{1} << 19;

void put(std::vector<std::uint8_t>& bytes, std::uint32_t value) { // big-endian
  const auto byte = [value](int shift) { return static_cast<std::uint8_t>(value >> shift); };
  bytes.insert(bytes.end(), {byte(24), byte(16), byte(8), byte(0)});
}

void put_chunk(std::vector<std::uint8_t>& bytes, const char* type, std::span<const std::uint8_t> data) {
  put(bytes, static_cast<std::uint32_t>(data.size()));
  bytes.insert(bytes.end(), type, type + 4);
  bytes.insert(bytes.end(), data.begin(), data.end());
  put(bytes, crc32_gzip_refl(0, bytes.data() + bytes.size() - data.size() - 4, data.size() + 4));
}

// The Paeth predictor (PNG specification, 9.4). Choosing a predictor for each row, as libpng does by default,
// made rendered pictures no smaller.
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

// Rows after rows, of both checksums; `row_bytes` when filtered.
std::uint32_t joined(std::uint32_t adler, const PngRows& next, std::size_t row_bytes) {
  const auto bytes = static_cast<z_off_t>(static_cast<std::size_t>(next.rows) * row_bytes);
  return static_cast<std::uint32_t>(adler32_combine(adler, next.adler, bytes));
}

PngRows encoded_band(std::span<const std::uint8_t> rgb, std::size_t row_bytes, bool last) {
  const std::size_t rows = rgb.size() / row_bytes;
  std::vector<std::uint8_t> filtered(rows * (row_bytes + 1));
  // Below nothing the predictor is that from the left alone, so that bands are independent.
  constexpr std::uint8_t from_left = 1;
  filter(rgb.data(), std::vector<std::uint8_t>(row_bytes).data(), row_bytes, filtered.data());
  filtered.front() = from_left;
  for (std::size_t i = 1; i < rows; ++i) {
    const std::uint8_t* const row = rgb.data() + i * row_bytes;
    filter(row, row - row_bytes, row_bytes, filtered.data() + i * (row_bytes + 1));
  }
  PngRows band{static_cast<std::int32_t>(rows), isal_adler32(1, filtered.data(), filtered.size()), {}};
  put_chunk(band.chunks, "IDAT", deflated(filtered, last));
  return band;
}

std::size_t row_bytes_of(std::int32_t width) {
  return channels * static_cast<std::size_t>(width);
}

} // namespace

// Level 1 of ISA-L takes a fifth of the time of libdeflate's level 5. Rendered pictures are a tenth larger on
// the whole, those of a few flat colours up to a third. Its levels 2 and 3 take longer and are no smaller.
//
// If nothing came before, the loop of its levels 1 and 2 looks up the third byte by a hash of where `stream`
// lies in memory (2.30 to 2.32): the same bytes aren't always the same piece. So the first few bytes, which
// are compressed without that loop, are a block of their own. It takes some ten bytes.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, bool last) {
  constexpr std::size_t first = 8; // of up to 3 it remembers nothing, and from 17 on it begins with the loop
  constexpr std::uint32_t level = 1, buffer_bytes = ISAL_DEF_LVL1_DEFAULT;
  const auto buffer = std::make_unique_for_overwrite<std::uint8_t[]>(buffer_bytes);
  // By the fixed codes of deflate, which a block has unless others are shorter, no byte is more than 9 bits.
  std::vector<std::uint8_t> piece(bytes.size() + bytes.size() / 8 + 64);
  isal_zstream stream; // NOLINT(cppcoreguidelines-pro-type-member-init): what is read is set
  isal_deflate_init(&stream);
  stream.level = level;
  stream.level_buf = buffer.get();
  stream.level_buf_size = buffer_bytes;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data()); // is only read
  stream.next_out = piece.data();
  stream.avail_out = static_cast<std::uint32_t>(piece.size());
  const auto deflate = [&](std::size_t count, std::uint16_t flush) {
    stream.avail_in = static_cast<std::uint32_t>(count);
    stream.flush = flush;
    if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.avail_out == 0)
      throw std::logic_error("deflate: no room");
  };
  const std::size_t before = std::min(first, bytes.size());
  deflate(before, SYNC_FLUSH);
  stream.end_of_stream = last ? 1 : 0;
  deflate(bytes.size() - before, last ? NO_FLUSH : FULL_FLUSH); // up to a whole byte
  piece.resize(stream.total_out);
  return piece;
}

std::int32_t png_band_rows(std::int32_t width) {
  return static_cast<std::int32_t>(std::max<std::size_t>(band_bytes / (row_bytes_of(width) + 1), 1));
}

PngRows encoded_rows(std::span<const std::uint8_t> rgb, std::int32_t width, bool last) {
  const std::size_t row_bytes = row_bytes_of(width), rows = rgb.size() / row_bytes,
                    band_rows = static_cast<std::size_t>(png_band_rows(width));
  std::vector<PngRows> bands((rows + band_rows - 1) / band_rows);
  parallel_for(bands.size(), [&](std::size_t i) {
    const std::size_t first = i * band_rows, count = std::min(band_rows, rows - first);
    bands[i] = encoded_band(rgb.subspan(first * row_bytes, count * row_bytes), row_bytes,
                            last && i + 1 == bands.size());
  });
  PngRows encoded{static_cast<std::int32_t>(rows), 1, {}};
  for (const PngRows& band : bands) {
    encoded.adler = joined(encoded.adler, band, row_bytes + 1);
    encoded.chunks.insert(encoded.chunks.end(), band.chunks.begin(), band.chunks.end());
  }
  return encoded;
}

std::vector<std::uint8_t> png_head(std::int32_t width, std::int32_t height, const PictureTexts& texts) {
  std::vector<std::uint8_t> bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}, header;
  put(header, static_cast<std::uint32_t>(width));
  put(header, static_cast<std::uint32_t>(height));
  header.insert(header.end(),
                {8, 2, 0, 0, 0}); // bits per channel; RGB; deflate; adaptive filters; not interlaced
  put_chunk(bytes, "IHDR", header);
  for (const auto& [keyword, text] : texts) {
    std::vector<std::uint8_t> data(keyword.begin(), keyword.end());
    data.push_back(0);
    data.insert(data.end(), text.begin(), text.end());
    put_chunk(bytes, "tEXt", data);
  }
  put_chunk(bytes, "IDAT", std::array<std::uint8_t, 2>{0x78, 0x5e}); // zlib's header: a window of 32 KiB
  return bytes;
}

PngWriter::PngWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PictureTexts& texts)
    : file_(file), row_bytes_(row_bytes_of(width) + 1), rows_left_(height) {
  file_.write(png_head(width, height, texts));
}

void PngWriter::write(const PngRows& rows) {
  file_.write(rows.chunks);
  adler_ = joined(adler_, rows, row_bytes_);
  rows_left_ -= rows.rows;
  if (rows_left_ > 0) return;
  std::vector<std::uint8_t> end, bytes;
  put(end, adler_);
  put_chunk(bytes, "IDAT", end);
  put_chunk(bytes, "IEND", {});
  file_.write(bytes);
}

void write_png(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
               const std::string& path, const PictureTexts& texts) {
  OutputFile file(path);
  PngWriter(file, width, height, texts).write(encoded_rows(rgb, width, true));
  file.commit();
}

} // namespace masu
