// The passes (libscene/passes/executor.h) that a device runs, as plain loops on one core: what is its
// own there is so here.
#pragma once

#include "libgrid/grid/merge_passes.h"
#include "libscene/passes/host_executor.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace masu {

struct DeviceLikeExecutor : SerialExecutor {
  static constexpr bool has_warps = true;

  // What nobody writes is nonsense, and not zero.
  template <class T>
  Array<T> array(std::uint64_t count) const {
    Array<T> values(count);
    const auto bytes = std::as_writable_bytes(std::span(values));
    std::fill(bytes.begin(), bytes.end(), std::byte{0xa5});
    return values;
  }
  template <class Value, class Emit>
  std::optional<Sorted<DeviceLikeExecutor, Value>>
  emit_sorted(std::uint64_t count, int /*bits*/, std::uint64_t max_pairs, const Emit& emit) const {
    Array<std::uint64_t> keys;
    Array<Value> values;
    for (std::uint64_t i = 0; i < count; ++i) {
      // As if rows were shared between threads.
      std::uint64_t rows = 1;
      if constexpr (has_size<Emit>) rows = emit.size(i);
      for (std::uint64_t row = 0; row < rows; row += 2) {
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
