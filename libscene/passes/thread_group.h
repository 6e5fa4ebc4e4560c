// Groups of threads that share a work item, after CUDA's cooperative groups: a single thread on the host; on
// the device a warp tile or a thread block (cuda_passes.h), with the same members.
#pragma once

#include "libscene/geometry/box.h"

#include <cstdint>

namespace masu {

// A thread takes thread_rank(), thread_rank() + size(), … of a list.
struct SingleThread {
  MASU_HD std::uint32_t thread_rank() const { return 0; }
  MASU_HD std::uint32_t size() const { return 1; }
  // A barrier; what was written before it is visible after it.
  MASU_HD void sync() const {}
  // Parts of a large group, of `width` threads side by side, that go each its own way: this thread's.
  template <unsigned width>
  MASU_HD SingleThread tile() const {
    return {};
  }
  // Adds to a counter that all threads share.
  MASU_HD void count(std::uint32_t& counter, std::uint32_t by = 1) const { counter += by; }
  // Makes a box that all threads share hold another.
  MASU_HD void join(Boxf& box, const Boxf& other) const { box = masu::join(box, other); }
  // Reductions over all threads, the result for each of them.
  MASU_HD std::uint64_t sum(std::uint64_t value) const { return value; }
  // Of a block: what its warps' values add up to, each one's the same for its threads: those before this
  // thread's, and `all`.
  MASU_HD std::uint32_t sum_of_warps_before(std::uint32_t of_warp, std::uint32_t& all) const {
    all = of_warp;
    return 0;
  }
  // Of a tile: a bit for each thread, the lowest for the first.
  MASU_HD std::uint32_t ballot(bool is) const { return is ? 1 : 0; }
  MASU_HD std::uint32_t all_bits(std::uint32_t bits) const { return bits; }
  // Of all threads' candidates the one that comes before all others, for the first thread.
  template <class Candidate>
  MASU_HD Candidate first_of_all(const Candidate& candidate) const {
    return candidate;
  }
};

// The join of all threads' parts, for each of them; of a block's, for its first.
template <class Part>
MASU_HD Part joined_by(const SingleThread&, const Part& own) {
  return own;
}

} // namespace masu
