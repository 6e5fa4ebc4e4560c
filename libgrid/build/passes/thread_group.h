// Groups of threads that share a work item, after CUDA's cooperative groups: a single thread on the host; on
// the device a warp tile or a thread block (cuda_executor.h), with the same members.
#pragma once

#include "libscene/base/portable.h"

#include <cstdint>

namespace masu {

// A thread takes thread_rank(), thread_rank() + size(), … of a list.
struct SingleThread {
  MASU_HD std::uint32_t thread_rank() const { return 0; }
  MASU_HD std::uint32_t size() const { return 1; }
  // A barrier; what was written before it is visible after it.
  MASU_HD void sync() const {}
  // Adds one to a counter that all threads share.
  MASU_HD void count(std::uint32_t& counter) const { ++counter; }
  // Makes what all threads share no greater, or no less, than the value.
  MASU_HD void lower(std::uint32_t& least, std::uint32_t value) const {
    least = value < least ? value : least;
  }
  MASU_HD void raise(std::uint32_t& most, std::uint32_t value) const { most = value > most ? value : most; }
  // Reductions over all threads, the result for each of them.
  MASU_HD std::uint64_t sum(std::uint64_t value) const { return value; }
  MASU_HD std::uint32_t all_bits(std::uint32_t bits) const { return bits; }
  // Of all threads' candidates the one that comes before all others, for the first thread.
  template <class Candidate>
  MASU_HD Candidate first_of_all(const Candidate& candidate) const {
    return candidate;
  }
};

} // namespace masu
