#include "renderer/image/png_file.h"

#include "libscene/base/parallel.h"
#include "renderer/image/deflate.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>

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

// The predictor from the left alone: of a band's first row, so that bands are independent.
void filter_first(const std::uint8_t* row, std::size_t bytes, std::uint8_t* filtered) {
  constexpr std::uint8_t sub = 1;
  *filtered++ = sub;
  for (std::size_t i = 0; i < bytes; ++i)
    filtered[i] = static_cast<std::uint8_t>(row[i] - (i < channels ? 0 : row[i - channels]));
}

// Rows after rows, of both checksums.
std::uint32_t joined(std::uint32_t adler, std::uint32_t next, std::size_t next_bytes) {
  return static_cast<std::uint32_t>(adler32_combine(adler, next, static_cast<z_off_t>(next_bytes)));
}

struct Band {
  std::vector<std::uint8_t> chunk;
  std::uint32_t adler = 1;
};

Band encoded_band(std::span<const std::uint8_t> rgb, std::size_t row_bytes, bool last) {
  const std::size_t rows = rgb.size() / row_bytes;
  std::vector<std::uint8_t> filtered(rows * (row_bytes + 1));
  filter_first(rgb.data(), row_bytes, filtered.data());
  for (std::size_t i = 1; i < rows; ++i) {
    const std::uint8_t* const row = rgb.data() + i * row_bytes;
    filter(row, row - row_bytes, row_bytes, filtered.data() + i * (row_bytes + 1));
  }
  Band band;
  put_chunk(band.chunk, "IDAT", deflated(filtered, last));
  band.adler = isal_adler32(1, filtered.data(), filtered.size());
  return band;
}

std::size_t row_bytes_of(std::int32_t width) {
  return channels * static_cast<std::size_t>(width);
}

} // namespace

std::int32_t png_band_rows(std::int32_t width) {
  return static_cast<std::int32_t>(std::max<std::size_t>(band_bytes / (row_bytes_of(width) + 1), 1));
}

PngRows encoded_rows(std::span<const std::uint8_t> rgb, std::int32_t width, bool last) {
  const std::size_t row_bytes = row_bytes_of(width), rows = rgb.size() / row_bytes,
                    band_rows = static_cast<std::size_t>(png_band_rows(width));
  std::vector<Band> bands((rows + band_rows - 1) / band_rows);
  const auto rows_of = [&](std::size_t band) { return std::min(band_rows, rows - band * band_rows); };
  parallel_for(bands.size(), [&](std::size_t i) {
    bands[i] = encoded_band(rgb.subspan(i * band_rows * row_bytes, rows_of(i) * row_bytes), row_bytes,
                            last && i + 1 == bands.size());
  });
  PngRows encoded{static_cast<std::int32_t>(rows), 1, {}};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    encoded.adler = joined(encoded.adler, bands[i].adler, rows_of(i) * (row_bytes + 1));
    encoded.chunks.insert(encoded.chunks.end(), bands[i].chunk.begin(), bands[i].chunk.end());
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
  adler_ = joined(adler_, rows.adler, static_cast<std::size_t>(rows.rows) * row_bytes_);
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
