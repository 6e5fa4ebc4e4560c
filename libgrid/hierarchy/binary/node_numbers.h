// Numbers of binary nodes, pair by pair, for threads that split at the same time.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace masu {

// From 1 on: 0 is the root's. Threads take blocks of them: were each pair taken from one counter, threads
// would wait for it, and for what others write side by side.
class NodeNumbers {
public:
  // For so many nodes.
  explicit NodeNumbers(std::size_t nodes) : nodes_(nodes), block_(nodes > (1 << 16) ? 256 : 2) {}

  // No number is as large, whatever threads leave of their blocks.
  std::size_t end() const { return nodes_ + (block_ > 2 ? most_with_blocks * block_ : 0); }

  // A thread's own.
  struct OfThread {
    std::uint32_t block, next = 0, end = 0;
  };
  OfThread& of_thread() { return of_threads_.local(); }

  // The left one's, which the right one's follows.
  std::uint32_t pair(OfThread& own) {
    if (own.next == own.end) {
      own.next = used_.fetch_add(own.block);
      own.end = own.next + own.block;
    }
    return std::exchange(own.next, own.next + 2);
  }

private:
  static constexpr std::uint32_t most_with_blocks = 256; // threads; others take pairs

  std::size_t nodes_;
  std::uint32_t block_;
  std::atomic<std::uint32_t> used_ = 1, threads_ = 0;
  tbb::enumerable_thread_specific<OfThread> of_threads_{
      [this] { return OfThread{threads_++ < most_with_blocks ? block_ : 2}; }};
};

} // namespace masu
