// Checks of a file's records, written once: by the host's cores where the records are in its memory, by a
// device (libscene/cuda/device_checker.h) where they were uploaded to. What is checked is what will be used.
//
// A checker has
//
//   all(count, good)    whether good(i) for all i = 0 … count - 1, in any order
//   zeros(count)        so many 32-bit words in its memory: data()
//
// Records on the host may be in a mapping of a file (file_mapping.h), which can change between two looks at
// it: what a check writes to by an index of the file's, it reads by read_once().
#pragma once

#include "libscene/base/host_array.h"
#include "libscene/base/portable.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <atomic>
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

MASU_HD inline std::uint32_t read_once(const std::uint32_t& word) {
  return *const_cast<const volatile std::uint32_t*>(&word);
}

// Of a word that many threads exchange: what was there before.
MASU_HD inline std::uint32_t exchanged(std::uint32_t& word, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return atomicExch(&word, value);
#else
  return std::atomic_ref(word).exchange(value, std::memory_order_relaxed);
#endif
}

// Adds to a sum that many threads add to: what it was before.
MASU_HD inline std::uint32_t added(std::uint32_t& sum, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return atomicAdd(&sum, value);
#else
  return std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed);
#endif
}

// A set of numbers below 32 times so many words: whether i wasn't in it yet; it is from now on.
MASU_HD inline bool inserted(std::uint32_t* words, std::uint64_t i) {
  const std::uint32_t bit = 1U << (i % 32);
#ifdef __CUDA_ARCH__
  return (atomicOr(words + i / 32, bit) & bit) == 0;
#else
  return (std::atomic_ref(words[i / 32]).fetch_or(bit, std::memory_order_relaxed) & bit) == 0;
#endif
}
inline std::uint64_t set_words(std::uint64_t numbers) {
  return (numbers + 31) / 32;
}

} // namespace masu
