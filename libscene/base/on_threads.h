// Threads that wait rather than compute: for devices and for files. Computing is TBB's.
#pragma once

#include <cstddef>
#include <future>
#include <vector>

namespace masu {

// Calls act(0) … act(count - 1) at the same time, each on a thread of its own. When all have ended, it throws
// what the first of those that failed threw.
template <class Act>
void on_threads(std::size_t count, const Act& act) {
  std::vector<std::future<void>> ended;
  for (std::size_t i = 0; i < count; ++i)
    ended.push_back(std::async(std::launch::async, [&act, i] { act(i); }));
  for (std::future<void>& end : ended)
    end.wait();
  for (std::future<void>& end : ended)
    end.get();
}

} // namespace masu
