// Executor (executor.h) on a CUDA device. CUDA sources only.
#pragma once

#include "libscene/base/progress_monitor.h"
#include "libscene/cuda/device_memory.h"
#include "libscene/passes/cuda_passes.h"
#include "libscene/passes/executor.h"

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>

namespace masu {

class CudaExecutor {
public:
  static constexpr bool has_warps = true;
  using Memory = CudaMemory;
  template <class T>
  using Array = DeviceArray<T>;

  // `pool`: of its arrays; it must outlive them. `progress`: of the build that the passes are of.
  explicit CudaExecutor(cudaMemPool_t pool, const ProgressMonitor* progress = nullptr,
                        cudaStream_t stream = nullptr)
      : memory_{stream, pool}, progress_(progress) {}
  CudaExecutor(const CudaExecutor&) = delete;
  CudaExecutor& operator=(const CudaExecutor&) = delete;

  template <class T>
  Array<T> array(std::uint64_t count) const {
    return is_small<T>(count) ? small<T>(count) : Array<T>(count, memory_);
  }
  template <class T>
  Array<T> zeros(std::uint64_t count) const {
    auto values = array<T>(count);
    if (!is_small<T>(count)) values.clear();
    return values;
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    check_progress(progress_);
    for_each_on_device(count, memory_.stream, act);
  }
  template <class Act>
  void for_each_part(std::uint64_t count, const Act& act) const {
    for_each(count, [=] MASU_PASS(std::uint64_t i) { act(i, i + 1); });
  }
  template <class Work>
  void for_each_by_group(std::uint64_t count, const Work& work) const {
    if (count == 0) return;
    check_progress(progress_);
    using namespace kernels;
    if constexpr (tile_width<Work>() > 32) {
      launch(one_by_block<Work>, static_cast<unsigned>(count), tile_width<Work>(), memory_.stream, work);
    } else {
      DeviceArray<std::uint32_t> large;
      if constexpr (has_size<Work>) {
        large = array<std::uint32_t>(count + 1);
        check(cudaMemsetAsync(large.data(), 0, sizeof(std::uint32_t), memory_.stream));
      }
      launch(each_by_tile<Work>, blocks_of(tiles<Work>, count), tiles<Work> * tile_width<Work>(),
             memory_.stream, count, work, large.data());
      if constexpr (has_size<Work>)
        launch(each_by_block<Work>, blocks_for_large, threads, memory_.stream, work, large.data());
    }
  }
  template <class Part, class Act>
  Array<Part> joined(std::uint64_t count, const Act& act) const {
    constexpr std::uint64_t max_blocks = 512;
    const unsigned blocks = std::max(
        1U, static_cast<unsigned>(std::min(max_blocks, (count + kernels::threads - 1) / kernels::threads)));
    check_progress(progress_);
    auto parts = array<Part>(1 + std::uint64_t{blocks});
    const auto arrivals = zeros<std::uint32_t>(1);
    launch(kernels::join_all<Part, Act>, blocks, kernels::threads, memory_.stream, count, act, parts.data(),
           arrivals.data());
    return parts;
  }
  template <class T>
  void scan(Array<T>& values) const {
    const std::uint64_t count = values.size();
    T* const value = values.data();
    if (count <= kernels::max_summed_by_block)
      return sum_by_block(values, [=] MASU_PASS(std::uint64_t i) { return value[i]; });
    with_memory([&](void* memory, std::size_t& bytes) {
      return cub::DeviceScan::ExclusiveSum(memory, bytes, value, value, count, memory_.stream);
    });
  }
  // What is summed up isn't computed as CUB reads it: many read far apart, and its blocks are few.
  template <class T, class Of>
  Array<T> sums(std::uint64_t count, const Of& of) const {
    auto values = array<T>(count);
    if (count <= kernels::max_summed_by_block) {
      sum_by_block(values, of);
      return values;
    }
    for_each(count, [=, value = values.data()] MASU_PASS(std::uint64_t i) { value[i] = of(i); });
    scan(values);
    return values;
  }
  // Such a copy, to memory that isn't page-locked, is waited for.
  template <class T>
  T value(const Array<T>& values, std::uint64_t i) const {
    T one;
    check(cudaMemcpyAsync(&one, values.data() + i, sizeof(T), cudaMemcpyDeviceToHost, memory_.stream));
    return one;
  }
  template <class KeyOf>
  Sorted<CudaExecutor, std::uint32_t> sorted(std::uint64_t count, int bits, const KeyOf& key_of) const {
    Sorted<CudaExecutor, std::uint32_t> sorted{array<std::uint64_t>(count), array<std::uint32_t>(count)};
    for_each(count, [=, keys = sorted.keys.data(), values = sorted.values.data()] MASU_PASS(std::uint64_t i) {
      keys[i] = key_of(i);
      values[i] = static_cast<std::uint32_t>(i);
    });
    sort(sorted.keys, sorted.values, bits);
    return sorted;
  }
  template <class Value, class Emit>
  std::optional<Sorted<CudaExecutor, Value>> emit_sorted(std::uint64_t count, int bits,
                                                         std::uint64_t max_pairs, const Emit& emit) const {
    kernels::EmittedPieces<Emit> pieces{emit, nullptr, count};
    std::uint64_t piece_count = count;
    Array<std::uint64_t> first_pieces;
    if constexpr (has_size<Emit>) {
      first_pieces =
          sums<std::uint64_t>(count + 1, [=] MASU_PASS(std::uint64_t i) { return pieces.of_item(i); });
      pieces.first_piece = first_pieces.data();
      piece_count = value(first_pieces, count);
    }
    const auto pairs = sums<std::uint64_t>(piece_count + 1, [=] MASU_PASS(std::uint64_t piece) {
      std::uint64_t own = 0;
      if (piece != piece_count) pieces(piece, [&](std::uint64_t, const Value&) { ++own; });
      return own;
    });
    const std::uint64_t pair_count = value(pairs, piece_count);
    if (pair_count > max_pairs) return std::nullopt;

    Sorted<CudaExecutor, Value> sorted{array<std::uint64_t>(pair_count), array<Value>(pair_count)};
    for_each(piece_count, [=, first_pair = pairs.data(), keys = sorted.keys.data(),
                           values = sorted.values.data()] MASU_PASS(std::uint64_t piece) {
      std::uint64_t offset = first_pair[piece];
      pieces(piece, [&](std::uint64_t key, const Value& value) {
        keys[offset] = key;
        values[offset++] = value;
      });
    });
    sort(sorted.keys, sorted.values, bits);
    return sorted;
  }

  const CudaExecutor& beside() const;
  void wait() const { check(cudaStreamSynchronize(memory_.stream)); }

private:
  struct Beside;

  // Small arrays are parts of one that was cleared as a whole, each only once: to allocate one, to clear it
  // and to give it back takes the host as long as a launch.
  static constexpr std::size_t most_small_bytes = 4096, block_bytes = std::size_t{1} << 18, aligned_to = 256;
  template <class T>
  static bool is_small(std::uint64_t count) {
    return count > 0 && count <= most_small_bytes / sizeof(T);
  }
  template <class T>
  Array<T> small(std::uint64_t count) const {
    if (block_ == nullptr || used_ + most_small_bytes > block_bytes) {
      const auto block = std::make_shared<const Array<std::uint8_t>>(block_bytes, memory_);
      block->clear();
      block_ = block;
      used_ = 0;
    }
    const std::size_t begin = used_;
    used_ += (count * sizeof(T) + aligned_to - 1) / aligned_to * aligned_to;
    return Array<T>(block_, begin, count);
  }

  template <class T, class Of>
  void sum_by_block(Array<T>& sums, const Of& of) const {
    launch(kernels::sum_by_block<T, Of>, 1, kernels::summing_threads, memory_.stream, sums.data(),
           static_cast<unsigned>(sums.size()), of);
  }
  template <class Value>
  void sort(Array<std::uint64_t>& keys, Array<Value>& values, int bits) const {
    if (keys.size() == 0) return;
    if constexpr (sizeof(Value) <= sizeof(std::uint64_t)) {
      using namespace kernels;
      if (keys.size() <= max_for_block) {
        launch(sort_by_block<Value>, 1, sorting_threads, memory_.stream, keys.data(), values.data(),
               static_cast<unsigned>(keys.size()), bits);
        return;
      }
    }
    auto other_keys = array<std::uint64_t>(keys.size());
    auto other_values = array<Value>(values.size());
    cub::DoubleBuffer<std::uint64_t> key_buffers(keys.data(), other_keys.data());
    cub::DoubleBuffer<Value> value_buffers(values.data(), other_values.data());
    with_memory([&](void* memory, std::size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(memory, bytes, key_buffers, value_buffers, keys.size(), 0, bits,
                                             memory_.stream);
    });
    if (key_buffers.Current() != keys.data()) keys = std::move(other_keys);
    if (value_buffers.Current() != values.data()) values = std::move(other_values);
  }

  // CUB's way: asked without memory, act says how many bytes it needs.
  template <class Act>
  void with_memory(const Act& act) const {
    std::size_t bytes = 0;
    check(act(nullptr, bytes));
    const auto memory = array<std::uint8_t>(std::max(bytes, std::size_t{1}));
    check(act(memory.data(), bytes));
  }

  StreamMemory memory_; // by default of the default stream
  const ProgressMonitor* progress_;
  mutable std::shared_ptr<const Array<std::uint8_t>> block_; // of small arrays,
  mutable std::size_t used_ = 0;                             // so many bytes of which are used
  mutable std::shared_ptr<const Beside> beside_;
};

struct CudaExecutor::Beside {
  Stream stream;
  Event begin;
  CudaExecutor executor;

  Beside(cudaMemPool_t pool, const ProgressMonitor* progress) : executor(pool, progress, stream) {}
};

inline const CudaExecutor& CudaExecutor::beside() const {
  if (beside_ == nullptr) beside_ = std::make_shared<const Beside>(memory_.pool, progress_);
  check(cudaEventRecord(beside_->begin, memory_.stream));
  check(cudaStreamWaitEvent(beside_->stream, beside_->begin));
  return beside_->executor;
}

} // namespace masu
