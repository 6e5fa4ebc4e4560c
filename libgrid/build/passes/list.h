// The lists of a grid's references, compared.
#pragma once

#include "libgrid/trace/grid_view.h"

namespace masu {

// Whether all primitives of the list `part` are in the list `whole`.
MASU_HD inline bool lists_all(const PrimitiveIndex* references, std::uint32_t whole, std::uint32_t part) {
  if (part == empty_list) return true;
  if (whole == empty_list) return false;
  for (;;) {
    const PrimitiveIndex wanted = references[part], found = references[whole];
    if ((wanted & ~last_bit) == (found & ~last_bit)) {
      if ((wanted & last_bit) != 0) return true;
      ++part;
    } else if ((wanted & ~last_bit) < (found & ~last_bit)) {
      return false;
    }
    if ((found & last_bit) != 0) return false;
    ++whole;
  }
}

// A bit for each primitive of a list, several to a bit: 0 for an empty list alone, and a part's bits are
// among the whole's.
MASU_HD inline std::uint32_t signature_of(const PrimitiveIndex* references, std::uint32_t list) {
  if (list == empty_list) return 0;
  std::uint32_t signature = 0;
  for (bool last = false; !last; ++list) {
    last = (references[list] & last_bit) != 0;
    // Neighbours in space are often numbered in steps: the golden ratio spreads them over the bits.
    signature |= 1U << ((references[list] & ~last_bit) * 0x9e3779b1U >> 27);
  }
  return signature;
}

} // namespace masu
