// Bits taken apart and put together: on the device in one instruction each, which a compiler doesn't find by
// itself.
#pragma once

#include "libscene/base/portable.h"

#include <bit>
#include <cstdint>

namespace masu {

MASU_HD inline std::uint32_t count_bits(std::uint32_t bits) {
#ifdef __CUDA_ARCH__
  return static_cast<std::uint32_t>(__popc(bits));
#else
  return static_cast<std::uint32_t>(std::popcount(bits));
#endif
}

MASU_HD inline std::int32_t leading_zeros(std::uint64_t bits) {
#ifdef __CUDA_ARCH__
  return __clzll(static_cast<long long>(bits));
#else
  return std::countl_zero(bits);
#endif
}

// `bits` with the highest `count` bits of `from` after them; 0 ≤ count < 32.
MASU_HD inline std::uint32_t appended(std::uint32_t bits, std::uint32_t from, std::int32_t count) {
#ifdef __CUDA_ARCH__
  return __funnelshift_l(from, bits, count);
#else
  return static_cast<std::uint32_t>((std::uint64_t{bits} << 32 | from) << count >> 32);
#endif
}

// The lowest `count` bits of `from` moved to the top, zeros behind them; 0 ≤ count < 32.
MASU_HD inline std::uint32_t moved_to_top(std::int32_t from, std::int32_t count) {
#ifdef __CUDA_ARCH__
  return __funnelshift_r(0, from, count);
#else
  return static_cast<std::uint32_t>(std::uint64_t{static_cast<std::uint32_t>(from)} << 32 >> count);
#endif
}

// The lower half of a word where `lower` is -1, the upper half where it is 0.
MASU_HD inline std::int32_t half(std::uint32_t word, std::int32_t lower) {
#ifdef __CUDA_ARCH__
  // A selector of bytes: 4 is a zero.
  return static_cast<std::int32_t>(__byte_perm(word, 0, 0x4432U ^ (static_cast<unsigned>(lower) & 0x22U)));
#else
  return static_cast<std::int32_t>(lower != 0 ? word & 0xffff : word >> 16);
#endif
}

} // namespace masu
