// The files of a view while its bands are written.
#pragma once

#include "tools/lists/hit_file.h"
#include "tools/render/picture_bands.h"

#include <atomic>
#include <memory>
#include <optional>

namespace masu {

// The files of a view; an empty name: not written. - is standard output.
struct ViewFiles {
  std::string picture, hits;
};

// Writes bands that come in any order, from threads at the same time. Files appear with the last one.
class ViewOutput {
public:
  // `bands` outlives it. Throw Error(output).
  ViewOutput(const ViewFiles& files, const PictureBands& bands, const ImageOptions& image,
             const std::vector<RecordField>& hit_fields);
  // Of what PictureBands makes of a band; without bytes where there is no such file.
  void write(std::size_t band, FilePart picture, std::vector<std::uint8_t> hits);

private:
  struct Png {
    Png(const std::string& path, std::int32_t width, std::int32_t height, const PngTexts& texts)
        : file(path), writer(file, width, height, texts) {}
    OutputFile file;
    PngWriter writer;
    InOrder<std::vector<std::uint8_t>> in_order;
  };

  const PictureBands& bands_;
  std::unique_ptr<Png> png_;
  std::optional<PlacedFile> pfm_;
  std::optional<HitFile> hits_;
  std::atomic<std::size_t> left_; // bands
};

} // namespace masu
