// Whether two values are equal bit for bit.
#pragma once

#include <array>
#include <bit>
#include <cstddef>

namespace masu::stability {

// Of types without padding.
template <class T>
bool same_bits(const T& a, const T& b) {
  using Bytes = std::array<std::byte, sizeof(T)>;
  return std::bit_cast<Bytes>(a) == std::bit_cast<Bytes>(b);
}

} // namespace masu::stability
