#include "tools/render/picture_bands.h"

#include "libscene/base/error.h"
#include "renderer/image/jpeg_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

namespace masu {
namespace {

// Rows of rays that two bands trace are less than one in a hundred, and a band keeps a GPU busy.
constexpr std::int32_t least_rows = 128, least_png_bands = 8;

struct PngPartHead {
  std::int32_t rows;
  std::uint32_t adler;
};

// Of a part of a PNG file.
PngRows png_rows(std::span<const std::uint8_t> part) {
  PngPartHead head{};
  if (part.size() < sizeof head)
    throw Error(ErrorCode::output, "PNG", "a band of it was changed while it was written: run again");
  std::memcpy(&head, part.data(), sizeof head);
  return {head.rows, head.adler, {part.begin() + sizeof head, part.end()}};
}

} // namespace

PictureBands::PictureBands(const RayWindow& rays, Sampling sampling, ImageFormat format)
    : rays_(rays), sampling_(sampling), format_(format), more_(sampling == Sampling::corners ? 1 : 0),
      height_(rays.rows - more_) {
  const std::int32_t side = std::max(width(), height_), png_rows = png_band_rows(width());
  if (format == ImageFormat::jpeg && side > largest_jpeg_side)
    throw Error(
        ErrorCode::usage, "--format",
        fmt::format("JPEG has at most {} pixels a side, not {}: write a PNG", largest_jpeg_side, side));
  band_rows_ = format == ImageFormat::jpeg
                   ? jpeg_band_rows(width())
                   : std::max(least_png_bands, (least_rows + png_rows - 1) / png_rows) * png_rows;
}

std::vector<std::uint8_t> PictureBands::hits(std::size_t band, const Frame& frame) const {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(frame.hits.data());
  return {first, first + rays_counted(band) * sizeof(HitRecord)};
}

std::vector<std::uint8_t> PictureBands::picture(std::size_t band, const Frame& frame,
                                                const ImageOptions& options) const {
  if (format_ == ImageFormat::pfm) {
    std::vector<std::uint8_t> bytes = pfm_rows(frame, sampling_);
    const std::string head = is_last(band) ? pfm_head(width(), height_) : "";
    bytes.insert(bytes.begin(), head.begin(), head.end());
    return bytes;
  }
  const std::vector<std::uint8_t> rgb = rgb_rows(frame, sampling_, options.srgb);
  if (format_ == ImageFormat::jpeg) return jpeg(rgb, width(), rows(band), {options.quality});
  const PngRows encoded = encoded_rows(rgb, width(), is_last(band));
  const PngPartHead head{encoded.rows, encoded.adler};
  std::vector<std::uint8_t> bytes(sizeof head);
  std::memcpy(bytes.data(), &head, sizeof head);
  bytes.insert(bytes.end(), encoded.chunks.begin(), encoded.chunks.end());
  return bytes;
}

KnownBy PictureBands::known_by(const PictureTexts& texts) const {
  if (format_ == ImageFormat::pfm) return {pfm_head(width(), height_), pfm_bytes(height_)};
  const std::vector<std::uint8_t> head =
      format_ == ImageFormat::jpeg ? jpeg_comment(texts) : png_head(width(), height_, texts);
  return {{head.begin(), head.end()}};
}

PartedForm PictureBands::picture_form(std::function<PictureTexts()> texts) const {
  if (format_ == ImageFormat::pfm) {
    // The bottom band comes first in the file, with the head.
    const auto offset = [this](std::uint64_t band) {
      return is_last(band) ? 0 : pfm_bytes(height_ - first_row(band) - rows(band));
    };
    return {count(), offset, pfm_bytes(height_)};
  }
  // Compression enlarges nothing by more than this. Of a JPEG it is twice TurboJPEG's own bound.
  const bool is_jpeg = format_ == ImageFormat::jpeg;
  const std::uint64_t row_bytes = (is_jpeg ? 12 : 3) * static_cast<std::uint64_t>(width()) + 1,
                      band_bytes = row_bytes * static_cast<std::uint64_t>(band_rows_),
                      slot_bytes = band_bytes + band_bytes / 64 + (std::uint64_t{1} << 16);
  return {count(), [slot_bytes](std::uint64_t band) { return band * slot_bytes; }, 0,
          [this, is_jpeg, texts = std::move(texts)](OutputFile& file) -> AppendPart {
            if (is_jpeg) {
              const auto writer = std::make_shared<JpegWriter>(file, width(), height_, texts());
              return [writer](std::span<const std::uint8_t> part) { writer->write(part); };
            }
            const auto writer = std::make_shared<PngWriter>(file, width(), height_, texts());
            return [writer](std::span<const std::uint8_t> part) { writer->write(png_rows(part)); };
          }};
}

} // namespace masu
