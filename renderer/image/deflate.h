// Compression for PNG: one deflate stream, made of pieces that are compressed independently.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace masu {

// A piece of a raw deflate stream (RFC 1951). Pieces one after the other are one stream, which the last piece
// ends. The same bytes give the same piece. At most 1 GiB. Throws std::bad_alloc.
std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, bool last);

} // namespace masu
