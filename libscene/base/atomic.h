// What many threads do to a word at once, in any order (relaxed, but for arrived()): one definition for host
// and device.
#pragma once

#include "libscene/base/portable.h"

#include <atomic>
#include <cstdint>

namespace masu {

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

// The same of values below 16 on a device, where the threads of a warp that are there add together.
MASU_HD inline std::uint32_t added_few(std::uint32_t& sum, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  const unsigned there = __activemask(), lane = threadIdx.x % lanes_per_warp, first = __ffs(there) - 1;
  std::uint32_t before = 0, all = 0;
  for (unsigned bit = 0; bit < 4; ++bit) {
    const unsigned have = __ballot_sync(there, (value >> bit & 1) != 0);
    before += static_cast<std::uint32_t>(__popc(have & ((1U << lane) - 1))) << bit;
    all += static_cast<std::uint32_t>(__popc(have)) << bit;
  }
  const std::uint32_t begin = lane == first ? atomicAdd(&sum, all) : 0;
  return before + __shfl_sync(there, begin, static_cast<int>(first));
#else
  return added(sum, value);
#endif
}

// Counts who comes to where threads meet: how many came before, of whom all that they wrote before is seen.
MASU_HD inline std::uint32_t arrived(std::uint32_t& count) {
#ifdef __CUDA_ARCH__
  std::uint32_t before; // by PTX: __threadfence() orders more than this asks for, and takes longer
  asm volatile("atom.acq_rel.gpu.add.u32 %0, [%1], 1;" : "=r"(before) : "l"(&count) : "memory");
  return before;
#else
  return std::atomic_ref(count).fetch_add(1, std::memory_order_acq_rel);
#endif
}

// Makes a word that many threads lower no greater than the value; or one that they raise no less.
template <bool raises>
MASU_HD inline void bound(std::uint32_t& word, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  raises ? atomicMax(&word, value) : atomicMin(&word, value);
#else
  const std::atomic_ref shared(word);
  for (std::uint32_t now = shared.load(std::memory_order_relaxed);
       (raises ? now < value : value < now) &&
       !shared.compare_exchange_weak(now, value, std::memory_order_relaxed);) {
  }
#endif
}
MASU_HD inline void lower(std::uint32_t& least, std::uint32_t value) {
  bound<false>(least, value);
}
MASU_HD inline void raise(std::uint32_t& most, std::uint32_t value) {
  bound<true>(most, value);
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
