// Stands in for libjpeg-turbo where the build found none.
#include "libscene/base/error.h"
#include "renderer/image/jpeg_file.h"

namespace masu {

std::vector<std::uint8_t> jpeg(std::span<const std::uint8_t>, std::int32_t, std::int32_t,
                               const JpegQuality&) {
  throw Error(ErrorCode::usage, "JPEG", "needs libjpeg-turbo: build where it is installed");
}

bool has_libjpeg() {
  return false;
}

} // namespace masu
