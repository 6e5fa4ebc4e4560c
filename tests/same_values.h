// Comparison of arrays, byte for byte.
#pragma once

#include <cstring>
#include <iterator>

namespace masu {

// Of records without padding.
template <class Values, class Others>
bool same_values(const Values& a, const Others& b) {
  static_assert(sizeof *std::data(a) == sizeof *std::data(b));
  return std::size(a) == std::size(b) &&
         (std::size(a) == 0 ||
          std::memcmp(std::data(a), std::data(b), std::size(a) * sizeof *std::data(a)) == 0);
}

} // namespace masu
