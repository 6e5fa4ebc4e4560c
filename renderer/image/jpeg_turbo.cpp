#include "libscene/base/error.h"
#include "renderer/image/jpeg_file.h"

#include <turbojpeg.h>

#include <memory>

namespace masu {

std::vector<std::uint8_t> jpeg(std::span<const std::uint8_t> rgb, std::int32_t width, std::int32_t height,
                               const JpegQuality& quality) {
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const bool encoded =
      encoder != nullptr && tjCompress2(encoder.get(), rgb.data(), width, 0, height, TJPF_RGB, &bytes, &size,
                                        quality.full_color ? TJSAMP_444 : TJSAMP_420, quality.quality,
                                        quality.full_color ? TJFLAG_ACCURATEDCT : TJFLAG_FASTDCT) == 0;
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(bytes, tjFree);
  if (!encoded) throw Error(ErrorCode::output, "picture", "can't be encoded as JPEG");
  return {bytes, bytes + size};
}

bool has_libjpeg() {
  return true;
}

} // namespace masu
