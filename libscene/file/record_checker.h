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
#include "libscene/base/parallel.h"

#include <atomic>
#include <cstdint>

namespace masu {

struct HostChecker {
  template <class Good>
  bool all(std::uint64_t count, const Good& good) const {
    std::atomic<bool> all = true;
    parallel_ranges(count, 256, [&](std::uint64_t i, std::uint64_t end) {
      while (i != end && good(i))
        ++i;
      if (i != end) all = false;
    });
    return all;
  }
  HostArray<std::uint32_t> zeros(std::uint64_t count) const { return HostArray<std::uint32_t>(count, 0); }
};

} // namespace masu
