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

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cstdint>
#include <functional>

namespace masu {

struct HostChecker {
  template <class Good>
  bool all(std::uint64_t count, const Good& good) const {
    constexpr std::uint64_t grain = 256;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint64_t>(0, count, grain), true,
        [&](const tbb::blocked_range<std::uint64_t>& range, bool so_far) {
          for (std::uint64_t i = range.begin(); so_far && i != range.end(); ++i)
            so_far = good(i);
          return so_far;
        },
        std::logical_and<>());
  }
  HostArray<std::uint32_t> zeros(std::uint64_t count) const { return HostArray<std::uint32_t>(count, 0); }
};

} // namespace masu
