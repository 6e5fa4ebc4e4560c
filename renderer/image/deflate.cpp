#include "renderer/image/deflate.h"

#include <isa-l/igzip_lib.h>

#include <memory>
#include <stdexcept>

namespace masu {

// Level 1 of ISA-L takes a fifth of the time of libdeflate's level 5. Rendered pictures are a tenth larger on
// the whole, those of a few flat colours up to a third. Its levels 2 and 3 take longer and are no smaller.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, bool last) {
  constexpr std::uint32_t level = 1, buffer_bytes = ISAL_DEF_LVL1_DEFAULT;
  const auto buffer = std::make_unique_for_overwrite<std::uint8_t[]>(buffer_bytes);
  // What can't be compressed is stored in blocks of up to 65535 bytes.
  std::vector<std::uint8_t> piece(bytes.size() + bytes.size() / 1024 + 64);
  isal_zstream stream;
  isal_deflate_stateless_init(&stream);
  stream.hist_bits = 0; // 2.30 leaves it as it was, and from 1 to 14 it changes which matches are found
  stream.level = level;
  stream.level_buf = buffer.get();
  stream.level_buf_size = buffer_bytes;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data()); // is only read
  stream.avail_in = static_cast<std::uint32_t>(bytes.size());
  stream.next_out = piece.data();
  stream.avail_out = static_cast<std::uint32_t>(piece.size());
  stream.end_of_stream = last ? 1 : 0;
  stream.flush = last ? NO_FLUSH : FULL_FLUSH; // up to a whole byte
  if (isal_deflate_stateless(&stream) != COMP_OK) throw std::logic_error("deflate: no room");
  piece.resize(stream.total_out);
  return piece;
}

} // namespace masu
