#include "renderer/image/deflate.h"

#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace masu {

// Level 1 of ISA-L takes a fifth of the time of libdeflate's level 5. Rendered pictures are a tenth larger on
// the whole, those of a few flat colours up to a third. Its levels 2 and 3 take longer and are no smaller.
//
// If nothing came before, the loop of its levels 1 and 2 looks up the third byte by a hash of where `stream`
// lies in memory (2.30 to 2.32): the same bytes aren't always the same piece. So the first few bytes, which
// are compressed without that loop, are a block of their own. It takes some ten bytes.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, bool last) {
  constexpr std::size_t first = 8; // of up to 3 it remembers nothing, and from 17 on it begins with the loop
  constexpr std::uint32_t level = 1, buffer_bytes = ISAL_DEF_LVL1_DEFAULT;
  const auto buffer = std::make_unique_for_overwrite<std::uint8_t[]>(buffer_bytes);
  // By the fixed codes of deflate, which a block has unless others are shorter, no byte is more than 9 bits.
  std::vector<std::uint8_t> piece(bytes.size() + bytes.size() / 8 + 64);
  isal_zstream stream; // NOLINT(cppcoreguidelines-pro-type-member-init): what is read is set
  isal_deflate_init(&stream);
  stream.level = level;
  stream.level_buf = buffer.get();
  stream.level_buf_size = buffer_bytes;
  stream.next_in = const_cast<std::uint8_t*>(bytes.data()); // is only read
  stream.next_out = piece.data();
  stream.avail_out = static_cast<std::uint32_t>(piece.size());
  const auto deflate = [&](std::size_t count, std::uint16_t flush) {
    stream.avail_in = static_cast<std::uint32_t>(count);
    stream.flush = flush;
    if (isal_deflate(&stream) != COMP_OK || stream.avail_in != 0 || stream.avail_out == 0)
      throw std::logic_error("deflate: no room");
  };
  const std::size_t before = std::min(first, bytes.size());
  deflate(before, SYNC_FLUSH);
  stream.end_of_stream = last ? 1 : 0;
  deflate(bytes.size() - before, last ? NO_FLUSH : FULL_FLUSH); // up to a whole byte
  piece.resize(stream.total_out);
  return piece;
}

} // namespace masu
