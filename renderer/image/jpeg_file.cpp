#include "renderer/image/jpeg_file.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

namespace masu {
namespace {

// Markers (ITU T.81, table B.1), which follow a byte 0xff.
constexpr std::uint8_t start_of_frame = 0xc0, restart = 0xd0, end_of_image = 0xd9, start_of_scan = 0xda,
                       restart_interval = 0xdd, comment = 0xfe;

constexpr std::int32_t block = 8; // pixels a side

std::int32_t blocks_of(std::int32_t pixels) {
  return (pixels + block - 1) / block;
}

std::array<std::uint8_t, 2> big_endian(std::size_t number) {
  return {static_cast<std::uint8_t>(number >> 8), static_cast<std::uint8_t>(number)};
}

std::vector<std::uint8_t> segment(std::uint8_t marker, std::span<const std::uint8_t> data) {
  const auto [high, low] = big_endian(data.size() + 2);
  std::vector<std::uint8_t> bytes{0xff, marker, high, low};
  bytes.resize(bytes.size() + data.size());
  std::ranges::copy_backward(data, bytes.end());
  return bytes;
}

// A picture: what comes before its codes, with the segment that has its size; and the codes.
struct Picture {
  std::vector<std::uint8_t> head;
  std::size_t frame = 0; // of the segment, in the head
  std::span<const std::uint8_t> codes;
};

Picture parsed(std::span<const std::uint8_t> bytes) {
  Picture picture;
  std::size_t at = 2; // after the start of image
  for (std::uint8_t marker = 0; marker != start_of_scan;) {
    if (bytes.size() < at + 6 || bytes[at] != 0xff) break;
    marker = bytes[at + 1];
    if (marker == start_of_frame) picture.frame = at;
    at += 2 + (std::size_t{bytes[at + 2]} << 8) + bytes[at + 3];
    if (marker == start_of_scan && picture.frame > 0 && at > picture.frame + 9 && bytes.size() >= at + 2 &&
        bytes[bytes.size() - 2] == 0xff && bytes.back() == end_of_image) {
      picture.head.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
      picture.codes = bytes.subspan(at, bytes.size() - at - 2);
      return picture;
    }
  }
  throw Error(ErrorCode::output, "JPEG", "a band of it was changed while it was written: run again");
}

} // namespace

// About 2 million pixels; more rows of them where the picture is wide, for bands trace their common row of
// rays twice; as far as a restart interval, which has 16 bits, counts blocks.
std::int32_t jpeg_band_rows(std::int32_t width) {
  constexpr std::int32_t blocks = 1 << 15, most_blocks = (1 << 16) - 1, rows = 16;
  return block * std::max(blocks / blocks_of(width), std::min(rows, most_blocks / blocks_of(width)));
}

std::vector<std::uint8_t> jpeg_comment(const PictureTexts& texts) {
  constexpr std::size_t longest = (1 << 16) - 3;
  std::string lines;
  for (const auto& [keyword, text] : texts)
    lines += fmt::format("{}: {}\n", keyword, text);
  if (lines.empty()) return {};
  lines.resize(std::min(lines.size() - 1, longest)); // without the last line's end
  return segment(comment, {reinterpret_cast<const std::uint8_t*>(lines.data()), lines.size()});
}

JpegWriter::JpegWriter(OutputFile& file, std::int32_t width, std::int32_t height, const PictureTexts& texts)
    : file_(file), width_(width), height_(height), comment_(jpeg_comment(texts)) {}

void JpegWriter::write(std::span<const std::uint8_t> band) {
  Picture picture = parsed(band);
  const std::int32_t rows = jpeg_band_rows(width_), bands = (height_ + rows - 1) / rows;
  std::ranges::copy(big_endian(static_cast<std::size_t>(height_)), &picture.head[picture.frame + 5]);
  if (band_ == 0) {
    std::vector<std::uint8_t> bytes = comment_;
    if (bands > 1) {
      const auto blocks = static_cast<std::size_t>(blocks_of(width_) * (rows / block));
      const std::vector<std::uint8_t> more = segment(restart_interval, big_endian(blocks));
      bytes.insert(bytes.end(), more.begin(), more.end());
    }
    file_.write(std::span(picture.head).first(picture.frame));
    file_.write(bytes);
    file_.write(std::span(picture.head).subspan(picture.frame));
    head_ = std::move(picture.head);
  } else {
    if (picture.head != head_)
      throw Error(ErrorCode::output, "JPEG", "its bands were encoded in different ways: run again");
    file_.write(std::array<std::uint8_t, 2>{0xff, static_cast<std::uint8_t>(restart + (band_ - 1) % 8)});
  }
  file_.write(picture.codes);
  if (++band_ == bands) file_.write(std::array<std::uint8_t, 2>{0xff, end_of_image});
}

} // namespace masu
