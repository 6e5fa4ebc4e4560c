// Checks of a file's records, written once: by the host's cores where the records are in its memory, by a
// device (libscene/cuda/device_checker.h) where they were uploaded to. What is checked is what will be used.
//
// A checker has
//
//   all(count, good)    whether good(i) for all i = 0 … count - 1, in any order
//   zeros(count)        so many 32-bit words in its memory: data()
//
// Records on the host may be in a mapping of a file (file_mapping.h), which can change between two looks at
// it: what a check writes to by an index of the file's, it reads by read_once() (libscene/base/atomic.h).
#pragma once

#include "libscene/base/atomic.h"
#include "libscene/base/host_array.h"

#include <cstdint>
#include <functional>

namespace masu {

// Whether good(begin, end) for every one of the ranges that 0 … count - 1 is cut into, in any order.
bool all_ranges(std::uint64_t count, const std::function<bool(std::uint64_t, std::uint64_t)>& good);

struct HostChecker {
  template <class Good>
  bool all(std::uint64_t count, const Good& good) const {
    return all_ranges(count, [&good](std::uint64_t i, std::uint64_t end) {
      while (i != end && good(i))
        ++i;
      return i == end;
    });
  }
  HostArray<std::uint32_t> zeros(std::uint64_t count) const { return HostArray<std::uint32_t>(count, 0); }
};

} // namespace masu
