// A picture in bands of rows: what is traced at a time, and where it lies in the picture's files.
#pragma once

#include "renderer/image/image.h"
#include "tools/jobs/parted_file.h"

namespace masu {

// Bands depend on the format and size of the picture (or of its part) alone, so files do, too.
class PictureBands {
public:
  // rays: the picture's or a part's. Throws Error(usage) for a JPEG that is too large.
  PictureBands(const RayWindow& rays, Sampling sampling, ImageFormat format);

  std::size_t count() const { return static_cast<std::size_t>((height_ + band_rows_ - 1) / band_rows_); }
  std::int32_t width() const { return rays_.columns - more_; } // pixels
  std::int32_t height() const { return height_; }

  // The rays of a band. With Sampling::corners the last row of rays of each band but the last is the next
  // one's first, which traces it again: the band that doesn't end the picture neither counts nor writes it.
  RayWindow rays(std::size_t band) const {
    return {rays_.first_column, rays_.first_row + first_row(band), rays_.columns, rows(band) + more_};
  }
  bool is_last(std::size_t band) const { return band + 1 == count(); }
  std::uint64_t rays_counted(std::size_t band) const {
    return rays_in(rows(band) + (is_last(band) ? more_ : 0));
  }
  std::size_t largest_band_rays() const { return rays_in(rows(0) + more_); }

  // What a band's frame gives for the picture's files: 8-byte records of the hits, and rows of the picture. A
  // PFM file's have the file's head with them; others' are encoded, and follow each other.
  std::vector<std::uint8_t> hits(std::size_t band, const Frame& frame) const;
  std::vector<std::uint8_t> picture(std::size_t band, const Frame& frame, const ImageOptions& options) const;
  // How these make the picture's file. `texts`: of a PNG or JPEG file. The bands outlive the form.
  PartedForm picture_form(std::function<PictureTexts()> texts) const;

  // What the picture's file is known by.
  KnownBy known_by(const PictureTexts& texts) const;

  // Its index in the picture.
  std::uint64_t first_hit(std::size_t band) const { return rays_in(first_row(band)); }
  // Of the whole picture.
  std::uint64_t hit_count() const { return rays_in(rays_.rows); }

private:
  std::int32_t first_row(std::size_t band) const { return static_cast<std::int32_t>(band) * band_rows_; }
  std::int32_t rows(std::size_t band) const { return std::min(band_rows_, height_ - first_row(band)); }
  std::uint64_t rays_in(std::int32_t rows) const {
    return static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(rays_.columns);
  }
  // Of a PFM file as far as so many rows from the bottom, with its head.
  std::uint64_t pfm_bytes(std::int32_t rows) const {
    const std::uint64_t pixels = static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(width());
    return pfm_head(width(), height_).size() + pixels * sizeof(Vec3f);
  }

  RayWindow rays_;
  Sampling sampling_;
  ImageFormat format_;
  std::int32_t more_, height_, band_rows_; // more_: rows and columns of rays than of pixels
};

} // namespace masu
