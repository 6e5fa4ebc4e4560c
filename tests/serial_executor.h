// Executor (libgrid/build/executor.h) as plain loops, one thing after the other.
#pragma once

#include "libgrid/build/merge_passes.h"
#include "libgrid/build/thread_group.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace masu {

struct SerialExecutor {
  template <class T>
  using Array = std::vector<T>;

  // What nobody writes is nonsense, and not zero.
  template <class T>
  Array<T> array(std::uint64_t count) const {
    Array<T> values(count);
    const auto bytes = std::as_writable_bytes(std::span(values));
    std::fill(bytes.begin(), bytes.end(), std::byte{0xa5});
    return values;
  }
  template <class T>
  Array<T> zeros(std::uint64_t count) const {
    return Array<T>(count);
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    for (std::uint64_t i = 0; i < count; ++i)
      act(i);
  }
  template <class Work>
  void for_each_by_lanes(std::uint64_t count, const Work& work) const {
    for (std::uint64_t i = 0; i < count; ++i) {
      typename Work::Scratch scratch;
      work(SingleThread{}, scratch, i);
    }
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
  template <class Value>
  void sort(Array<std::uint64_t>& keys, Array<Value>& values, int bits) const {
    const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return (keys[a] & mask) < (keys[b] & mask); });
    const auto sorted = [&](auto& all) {
      auto copy = all;
      for (std::size_t i = 0; i < order.size(); ++i)
        copy[i] = all[order[i]];
      all = std::move(copy);
    };
    sorted(keys);
    sorted(values);
  }
};

inline Grid as_grid(PassesGrid<SerialExecutor> grid) {
  return {grid.layout,
          grid.merge,
          grid.block_log2,
          grid.nested_log2,
          std::move(grid.voxel_map),
          std::move(grid.cells),
          std::move(grid.references)};
}

} // namespace masu
