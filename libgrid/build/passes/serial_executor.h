// Executor (executor.h) of plain loops: for one thread.
#pragma once

#include "libgrid/build/passes/executor.h"
#include "libgrid/build/passes/thread_group.h"
#include "libscene/base/host_array.h"

#include <utility>

namespace masu {

struct SerialExecutor {
  static constexpr bool has_warps = false;
  template <class T>
  using Array = HostArray<T>;

  template <class T>
  Array<T> array(std::uint64_t count) const {
    return Array<T>(count);
  }
  template <class T>
  Array<T> zeros(std::uint64_t count) const {
    return Array<T>(count, T{});
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    for (std::uint64_t i = 0; i < count; ++i)
      act(i);
  }
  template <class Work>
  void for_each_by_group(std::uint64_t count, const Work& work) const {
    typename Work::Scratch scratch;
    for (std::uint64_t i = 0; i < count; ++i)
      work(SingleThread{}, scratch, i);
  }
  template <class T>
  void scan(Array<T>& values) const {
    T sum{};
    for (T& value : values)
      value = std::exchange(sum, sum + value);
  }
  template <class T>
  T value(const Array<T>& values, std::uint64_t i) const {
    return values[i];
  }
  // Adds to a counter, and returns what it was before.
  static std::uint32_t fetch_add(std::uint32_t& counter, std::uint32_t by) {
    return std::exchange(counter, counter + by);
  }
};

} // namespace masu
