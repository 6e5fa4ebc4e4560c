// How many elements of a list are done, on the CPU.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace masu {

// Threads say which elements they have done, each once and in any order; `report` gets the share of all from
// time to time, and what it throws ends the query. It may be empty, and must outlive this.
class ListProgress {
public:
  // Reports every so many elements, a power of two; or more often where each takes so many tests.
  ListProgress(const std::function<void(double)>& report, std::size_t count, std::size_t every,
               std::uint64_t tests_each)
      : report_(report), count_(count), every_(every) {
    constexpr std::uint64_t tests_in_a_row = 1 << 18; // some milliseconds
    while (every_ > 1 && every_ * tests_each > tests_in_a_row)
      every_ /= 2;
  }
  void done(std::size_t i) {
    if ((i & (every_ - 1)) == 0) report();
  }

private:
  [[gnu::noinline]] void report() {
    if (!report_) return;
    const std::size_t done = done_.fetch_add(every_, std::memory_order_relaxed) + every_;
    report_(done < count_ ? static_cast<double>(done) / static_cast<double>(count_) : 1);
  }

  const std::function<void(double)>& report_;
  std::size_t count_, every_;
  std::atomic<std::size_t> done_ = 0;
};

} // namespace masu
