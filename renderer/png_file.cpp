#include "renderer/png_file.h"

#include "libscene/error.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <png.h>

namespace masu {

void write_png(const std::vector<std::uint8_t>& rgb, std::int32_t width, std::int32_t height,
               const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(width);
  png.height = static_cast<png_uint_32>(height);
  png.format = PNG_FORMAT_RGB;
  OutputFile file(path);
  if (png_image_write_to_stdio(&png, file.stream(), 0, rgb.data(), 0, nullptr) == 0) {
    throw Error(ErrorCode::output, path, fmt::format("can't be written: {}", png.message));
  }
  file.commit();
}

} // namespace masu
