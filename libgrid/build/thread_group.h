// Threads that share a piece of work: one of them on the host; on the device a warp's or a block's
// (device_passes.h), with the same members.
#pragma once

#include "libscene/portable.h"

#include <cstdint>

namespace masu {

// Each lane has the numbers lane(), lane() + size(), … of what is to be done.
struct SingleThread {
  MASU_HD std::uint32_t lane() const { return 0; }
  MASU_HD std::uint32_t size() const { return 1; }
  // Until all lanes have come here, and see what each of them has written.
  MASU_HD void wait() const {}
  // One more of what all lanes count.
  MASU_HD void count(std::uint32_t& counter) const { ++counter; }
  // Over all lanes, for each of them.
  MASU_HD std::uint64_t sum(std::uint64_t value) const { return value; }
  MASU_HD std::uint32_t all_bits(std::uint32_t bits) const { return bits; }
  // Of all lanes' candidates, the one that comes before all others: for the first lane.
  template <class Candidate>
  MASU_HD Candidate first_of_all(const Candidate& candidate) const {
    return candidate;
  }
};

} // namespace masu
