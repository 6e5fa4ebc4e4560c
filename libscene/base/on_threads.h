// Threads that wait rather than compute: for devices and for files. Computing is TBB's.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <vector>

namespace masu {

// Calls act(0) … act(count - 1) at the same time, each on a thread of its own, a single one on the caller's.
// When all have ended, it throws what the first of those that failed threw. `meanwhile` is called every now
// and then by the thread that waits for them; what it throws is thrown when all have ended.
template <class Act>
void on_threads(std::size_t count, const Act& act, const std::function<void()>& meanwhile = {}) {
  if (count == 1 && !meanwhile) return act(0);
  std::vector<std::future<void>> ended;
  for (std::size_t i = 0; i < count; ++i)
    ended.push_back(std::async(std::launch::async, [&act, i] { act(i); }));
  for (std::future<void>& end : ended) {
    while (meanwhile && end.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      meanwhile();
    end.wait();
  }
  for (std::future<void>& end : ended)
    end.get();
}

} // namespace masu
