#include "tools/render/view_output.h"

namespace masu {

ViewOutput::ViewOutput(const ViewFiles& files, const PictureBands& bands, const ImageOptions& image,
                       const std::vector<RecordField>& hit_fields)
    : bands_(bands), left_(bands.count()) {
  const std::int32_t width = bands.width(), height = bands.height();
  if (!files.hits.empty()) hits_.emplace(HitFormat(files.hits, hit_fields), files.hits, bands.hit_count());
  if (files.picture.empty()) return;
  if (image.format == ImageFormat::pfm) {
    pfm_.emplace(files.picture);
  } else {
    png_ = std::make_unique<Png>(files.picture, width, height, image.texts);
  }
}

void ViewOutput::write(std::size_t band, FilePart picture, std::vector<std::uint8_t> hits) {
  if (png_)
    png_->in_order.add(band, band + 1, std::move(picture.bytes),
                       [&](const auto& part) { png_->writer.write(png_rows(part)); });
  if (pfm_) pfm_->write(std::move(picture));
  if (hits_) hits_->write(bands_.first_hit(band), std::move(hits));
  if (--left_ > 0) return;
  if (png_) png_->file.commit();
  if (pfm_) pfm_->commit();
  if (hits_) hits_->commit(bands_.hit_count());
}

} // namespace masu
