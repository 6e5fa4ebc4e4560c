// The passes (libgrid/build/passes/executor.h) that a device runs, as plain loops: what is its own there is
// so here.
#pragma once

#include "libgrid/build/passes/merge_passes.h"
#include "libgrid/build/passes/thread_group.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace masu {

struct DeviceLikeExecutor {
  static constexpr bool has_warps = true;
  using Memory = HostMemory;
  template <class T>
  using Array = HostArray<T>;

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
    return Array<T>(count, T{});
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    for (std::uint64_t i = 0; i < count; ++i)
      act(i);
  }
  template <class Work>
  void for_each_by_group(std::uint64_t count, const Work& work) const {
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
  static std::uint32_t fetch_add(std::uint32_t& counter, std::uint32_t by) {
    return std::exchange(counter, counter + by);
  }
  static void lower(std::uint32_t& least, std::uint32_t value) { least = std::min(least, value); }
  template <class Value, class Emit>
  std::optional<Sorted<DeviceLikeExecutor, Value>>
  emit_sorted(std::uint64_t count, int /*bits*/, std::uint64_t max_pairs, const Emit& emit) const {
    Array<std::uint64_t> keys;
    Array<Value> values;
    for (std::uint64_t i = 0; i < count; ++i) {
      // As if rows were shared between threads.
      for (std::uint64_t row = 0; row < emit.size(i); row += 2) {
        emit(i, row, row + 2, [&](std::uint64_t key, const Value& value) {
          keys.push_back(key);
          values.push_back(value);
        });
      }
    }
    if (keys.size() > max_pairs) return std::nullopt;
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    const auto sorted = [&](auto& all) {
      auto copy = all;
      for (std::size_t i = 0; i < order.size(); ++i)
        copy[i] = all[order[i]];
      all = std::move(copy);
    };
    sorted(keys);
    sorted(values);
    return Sorted<DeviceLikeExecutor, Value>{std::move(keys), std::move(values)};
  }
};

} // namespace masu
