// Executor (executor.h) on a CUDA device. CUDA sources only.
#pragma once

#include "libscene/base/atomic.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/cuda/device_memory.h"
#include "libscene/passes/executor.h"

#include <cub/block/block_radix_sort.cuh>
#include <cub/block/block_scan.cuh>
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <optional>

namespace masu {

// What a group's threads share.
struct SharedByThreads {
  __device__ void count(std::uint32_t& counter, std::uint32_t by = 1) const { atomicAdd(&counter, by); }
  __device__ void join(Boxf& box, const Boxf& other) const {
    lower(box.min.x, other.min.x);
    lower(box.min.y, other.min.y);
    lower(box.min.z, other.min.z);
    raise(box.max.x, other.max.x);
    raise(box.max.y, other.max.y);
    raise(box.max.z, other.max.z);
  }

private:
  // The bits of floats, but for -0, are in their order as whole numbers from 0 on, in the opposite one below.
  __device__ static void lower(float& least, float value) {
    if (value + 0 >= 0)
      atomicMin(reinterpret_cast<int*>(&least), __float_as_int(value + 0));
    else
      atomicMax(reinterpret_cast<unsigned*>(&least), __float_as_uint(value));
  }
  __device__ static void raise(float& most, float value) {
    if (value + 0 >= 0)
      atomicMax(reinterpret_cast<int*>(&most), __float_as_int(value + 0));
    else
      atomicMin(reinterpret_cast<unsigned*>(&most), __float_as_uint(value));
  }
};

// Some of a warp's threads, `width` (a power of two) side by side, as thread_group.h has them.
template <unsigned width>
struct WarpTile : SharedByThreads {
  __device__ std::uint32_t thread_rank() const { return threadIdx.x % width; }
  __device__ std::uint32_t size() const { return width; }
  __device__ void sync() const { __syncwarp(all()); }
  __device__ std::uint64_t sum(std::uint64_t value) const {
    for (unsigned apart = width / 2; apart > 0; apart /= 2)
      value += __shfl_xor_sync(all(), value, static_cast<int>(apart));
    return value;
  }
  __device__ std::uint32_t all_bits(std::uint32_t bits) const {
    for (unsigned apart = width / 2; apart > 0; apart /= 2)
      bits |= __shfl_xor_sync(all(), bits, static_cast<int>(apart));
    return bits;
  }
  template <class Candidate>
  __device__ Candidate first_of_all(Candidate first) const {
    for (unsigned apart = width / 2; apart > 0; apart /= 2) {
      const Candidate other = of_lane(first, thread_rank() ^ apart);
      if (comes_before(other, first)) first = other;
    }
    return first;
  }

  // Another lane's record.
  template <class Record>
  __device__ Record of_lane(const Record& own, std::uint32_t other) const {
    static_assert(sizeof(Record) % sizeof(std::uint32_t) == 0);
    struct Words {
      std::uint32_t word[sizeof(Record) / sizeof(std::uint32_t)];
    };
    auto words = std::bit_cast<Words>(own);
    for (std::uint32_t& word : words.word)
      word = __shfl_sync(all(), word, static_cast<int>(other), width);
    return std::bit_cast<Record>(words);
  }

private:
  __device__ static unsigned all() {
    return width == 32 ? 0xffffffffU : ((1U << width % 32) - 1) << (threadIdx.x % 32 / width * width);
  }
};

// The join of all lanes' parts, for each of them.
template <unsigned width, class Part>
__device__ Part joined_by(const WarpTile<width>& tile, Part own) {
  for (unsigned apart = width / 2; apart > 0; apart /= 2)
    own = join(own, tile.of_lane(own, tile.thread_rank() ^ apart));
  return own;
}

// A block's threads. Candidates are the first warp's.
struct ThreadBlock : SharedByThreads {
  __device__ std::uint32_t thread_rank() const { return threadIdx.x; }
  __device__ std::uint32_t size() const { return blockDim.x; }
  __device__ void sync() const { __syncthreads(); }
  template <unsigned width>
  __device__ WarpTile<width> tile() const {
    return {};
  }
  template <unsigned width>
  __device__ std::uint32_t tile_rank() const {
    return threadIdx.x / width;
  }
  template <unsigned width>
  __device__ std::uint32_t tile_count() const {
    return blockDim.x / width;
  }
  __device__ std::uint64_t sum(std::uint64_t value) const {
    __shared__ unsigned long long total;
    __syncthreads(); // the last call's has been read by all
    if (threadIdx.x == 0) total = 0;
    __syncthreads();
    const std::uint64_t own = WarpTile<32>{}.sum(value);
    if (threadIdx.x % 32 == 0) atomicAdd(&total, static_cast<unsigned long long>(own));
    __syncthreads();
    return total;
  }
  __device__ std::uint32_t all_bits(std::uint32_t bits) const {
    __shared__ std::uint32_t together;
    __syncthreads();
    if (threadIdx.x == 0) together = 0;
    __syncthreads();
    atomicOr(&together, bits);
    __syncthreads();
    return together;
  }
  template <class Candidate>
  __device__ Candidate first_of_all(const Candidate& own) const {
    return threadIdx.x < 32 ? WarpTile<32>{}.first_of_all(own) : own;
  }
};

// The join of all threads' parts, for the first of them.
template <class Part>
__device__ Part joined_by(const ThreadBlock& block, Part own) {
  constexpr unsigned warp = 32, max_warps = 32;
  __shared__ alignas(Part) std::byte memory[max_warps * sizeof(Part)];
  Part* const parts = reinterpret_cast<Part*>(memory);
  own = joined_by(WarpTile<warp>{}, own);
  block.sync(); // the last call's have been read
  if (threadIdx.x % warp == 0) parts[threadIdx.x / warp] = own;
  block.sync();
  if (threadIdx.x >= warp) return own;
  return joined_by(WarpTile<warp>{}, threadIdx.x < blockDim.x / warp ? parts[threadIdx.x] : Part{});
}

namespace kernels {

inline constexpr unsigned threads = 256;

// What another block has written during this kernel, which the L1 may not know.
template <class Part>
__device__ Part read_past_l1(const Part* from) {
  struct Words {
    std::uint32_t word[sizeof(Part) / sizeof(std::uint32_t)];
  } words;
  for (unsigned k = 0; k < sizeof(Part) / sizeof(std::uint32_t); ++k)
    words.word[k] = __ldcg(reinterpret_cast<const std::uint32_t*>(from) + k);
  return std::bit_cast<Part>(words);
}

// Each block joins its share; the last to come joins what they have left.
template <class Part, class Act>
__global__ void __launch_bounds__(threads)
    join_all(std::uint64_t count, const __grid_constant__ Act act, Part* parts, std::uint32_t* arrivals) {
  __shared__ bool is_last;
  Part own{};
  for (std::uint64_t i = std::uint64_t{blockIdx.x} * threads + threadIdx.x; i < count;
       i += std::uint64_t{gridDim.x} * threads)
    own = join(own, act(i));
  own = joined_by(ThreadBlock{}, own);
  if (threadIdx.x == 0) {
    parts[1 + blockIdx.x] = own;
    is_last = arrived(*arrivals) == gridDim.x - 1;
    if (is_last) *arrivals = 0; // for the next kernel
  }
  __syncthreads();
  if (!is_last) return;
  own = {};
  for (unsigned i = threadIdx.x; i < gridDim.x; i += threads)
    own = join(own, read_past_l1(parts + 1 + i));
  own = joined_by(ThreadBlock{}, own);
  if (threadIdx.x == 0) parts[0] = own;
}

// Most boxes hold few things: eight threads share one. What is too much for them is put on a list, whose
// length is large[0].
inline constexpr unsigned max_for_tile = 256;
template <class Work>
concept has_size = requires(const Work& work) {
  work.size(0);
};
template <class Work>
constexpr unsigned tile_width() {
  if constexpr (requires { Work::threads; }) return Work::threads;
  return 8;
}
// Tiles of a block: as many as its shared memory holds the scratch of.
template <class Work>
inline constexpr unsigned
    tiles = std::min(threads / tile_width<Work>(),
                     std::bit_floor(unsigned{48 * 1024 / sizeof(typename Work::Scratch)}));
template <class Work>
__global__ void __launch_bounds__(tiles<Work>* tile_width<Work>())
    each_by_tile(std::uint64_t count, const __grid_constant__ Work work, std::uint32_t* large) {
  __shared__ typename Work::Scratch scratch[tiles<Work>];
  constexpr unsigned width = tile_width<Work>();
  const unsigned own = threadIdx.x / width;
  const std::uint64_t i = std::uint64_t{blockIdx.x} * tiles<Work> + own;
  if (i >= count) return;
  if constexpr (has_size<Work>) {
    if (work.size(i) > max_for_tile) {
      if (threadIdx.x % width == 0) large[1 + atomicAdd(large, 1U)] = static_cast<std::uint32_t>(i);
      return;
    }
  }
  work(WarpTile<width>{}, scratch[own], i);
}

// Of what a block shares each.
template <class Work>
__global__ void __launch_bounds__(Work::threads) one_by_block(const __grid_constant__ Work work) {
  __shared__ typename Work::Scratch scratch;
  work(ThreadBlock{}, scratch, blockIdx.x);
}

inline constexpr unsigned blocks_for_large = 1024;
template <class Work>
__global__ void __launch_bounds__(threads)
    each_by_block(const __grid_constant__ Work work, const std::uint32_t* large) {
  __shared__ typename Work::Scratch scratch;
  for (std::uint32_t i = blockIdx.x; i < large[0]; i += gridDim.x) {
    work(ThreadBlock{}, scratch, large[1 + i]);
    __syncthreads();
  }
}

// So few are sorted by one block, in half of the time that CUB's passes over memory take.
inline constexpr unsigned sorting_threads = 512, sorted_by_thread = 8, bits_at_once = 5,
                          max_for_block = sorting_threads * sorted_by_thread;
template <class Value>
__global__ void __launch_bounds__(sorting_threads)
    sort_by_block(std::uint64_t* keys, Value* values, unsigned count, int bits) {
  using Sort = cub::BlockRadixSort<std::uint64_t, sorting_threads, sorted_by_thread, Value, bits_at_once>;
  __shared__ typename Sort::TempStorage memory;
  std::uint64_t own_keys[sorted_by_thread];
  Value own_values[sorted_by_thread];
  for (unsigned k = 0; k < sorted_by_thread; ++k) {
    const unsigned i = threadIdx.x * sorted_by_thread + k;
    own_keys[k] = i < count ? keys[i] : ~std::uint64_t{0}; // after all others
    own_values[k] = i < count ? values[i] : Value{};
  }
  Sort(memory).SortBlockedToStriped(own_keys, own_values, 0, bits);
  for (unsigned k = 0; k < sorted_by_thread; ++k) {
    const unsigned i = k * sorting_threads + threadIdx.x;
    if (i >= count) continue;
    keys[i] = own_keys[k];
    values[i] = own_values[k];
  }
}

struct Sum {
  template <class T>
  MASU_HD T operator()(const T& a, const T& b) const {
    return a + b;
  }
};

// So few are summed up by one block, piece by piece, sooner than CUB's kernels are launched; and what is
// summed up is computed there, too, where it is one piece.
inline constexpr unsigned summing_threads = 512, summed_by_thread = 8,
                          summed_at_once = summing_threads * summed_by_thread,
                          max_summed_by_block = 8 * summed_at_once;
template <class T, class Of>
__global__ void __launch_bounds__(summing_threads)
    sum_by_block(T* sums, unsigned count, const __grid_constant__ Of of) {
  using Scan = cub::BlockScan<T, summing_threads>;
  __shared__ typename Scan::TempStorage memory;
  T before{};
  for (unsigned piece = 0; piece < count; piece += summed_at_once) {
    const unsigned first = piece + threadIdx.x * summed_by_thread;
    T own[summed_by_thread], all;
    for (unsigned k = 0; k < summed_by_thread; ++k)
      own[k] = first + k < count ? of(first + k) : T{};
    Scan(memory).ExclusiveScan(own, own, T{}, Sum{}, all);
    for (unsigned k = 0; k < summed_by_thread; ++k)
      if (first + k < count) sums[first + k] = before + own[k];
    before = before + all;
    __syncthreads(); // the memory has been read
  }
}

} // namespace kernels

class CudaExecutor {
public:
  static constexpr bool has_warps = true;
  static constexpr unsigned lanes = 1;
  using Memory = CudaMemory;
  template <class T>
  using Array = DeviceArray<T>;

  // `pool`: of its arrays; it must outlive them. `progress`: of the build that the passes are of.
  explicit CudaExecutor(cudaMemPool_t pool, const ProgressMonitor* progress = nullptr)
      : memory_{nullptr, pool}, progress_(progress) {}
  CudaExecutor(const CudaExecutor&) = delete;
  CudaExecutor& operator=(const CudaExecutor&) = delete;

  template <class T>
  Array<T> array(std::uint64_t count) const {
    return Array<T>(count, memory_);
  }
  template <class T>
  Array<T> zeros(std::uint64_t count) const {
    Array<T> values(count, memory_);
    values.clear();
    return values;
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    check_progress(progress_);
    for_each_on_device(count, nullptr, act);
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
      launch(one_by_block<Work>, static_cast<unsigned>(count), tile_width<Work>(), nullptr, work);
    } else {
      DeviceArray<std::uint32_t> large;
      if constexpr (has_size<Work>) {
        large = array<std::uint32_t>(count + 1);
        check(cudaMemsetAsync(large.data(), 0, sizeof(std::uint32_t), nullptr));
      }
      launch(each_by_tile<Work>, blocks_of(tiles<Work>, count), tiles<Work> * tile_width<Work>(), nullptr,
             count, work, large.data());
      if constexpr (has_size<Work>)
        launch(each_by_block<Work>, blocks_for_large, threads, nullptr, work, large.data());
    }
  }
  template <class Part, class Act>
  Array<Part> joined(std::uint64_t count, const Act& act) const {
    constexpr std::uint64_t max_blocks = 512;
    const unsigned blocks = std::max(
        1U, static_cast<unsigned>(std::min(max_blocks, (count + kernels::threads - 1) / kernels::threads)));
    check_progress(progress_);
    auto parts = array<Part>(1 + std::uint64_t{blocks});
    if (arrivals_.size() == 0) arrivals_ = zeros<std::uint32_t>(1);
    launch(kernels::join_all<Part, Act>, blocks, kernels::threads, nullptr, count, act, parts.data(),
           arrivals_.data());
    return parts;
  }
  template <class T>
  void scan(Array<T>& values) const {
    const std::uint64_t count = values.size();
    T* const value = values.data();
    if (count <= kernels::max_summed_by_block)
      return sum_by_block(values, [=] MASU_PASS(std::uint64_t i) { return value[i]; });
    with_memory([&](void* memory, std::size_t& bytes) {
      return cub::DeviceScan::ExclusiveScan(memory, bytes, value, value, kernels::Sum{}, T{}, count);
    });
  }
  template <class T, class Of>
  Array<T> sums(std::uint64_t count, const Of& of) const {
    auto values = array<T>(count);
    if (count <= kernels::summed_at_once) {
      sum_by_block(values, of);
      return values;
    }
    T* const value = values.data();
    for_each(count, [=] MASU_PASS(std::uint64_t i) { value[i] = of(i); });
    scan(values);
    return values;
  }
  template <class T>
  T value(const Array<T>& values, std::uint64_t i) const {
    T one;
    check(cudaMemcpy(&one, values.data() + i, sizeof(T), cudaMemcpyDeviceToHost));
    return one;
  }
  template <class KeyOf>
  Sorted<CudaExecutor, std::uint32_t> sorted(std::uint64_t count, int bits, const KeyOf& key_of) const {
    Sorted<CudaExecutor, std::uint32_t> sorted{array<std::uint64_t>(count), array<std::uint32_t>(count)};
    std::uint64_t* const keys = sorted.keys.data();
    std::uint32_t* const values = sorted.values.data();
    for_each(count, [=] MASU_PASS(std::uint64_t i) {
      keys[i] = key_of(i);
      values[i] = static_cast<std::uint32_t>(i);
    });
    sort(sorted.keys, sorted.values, bits);
    return sorted;
  }
  // Items are gone through in pieces of so many rows, so that threads share a large one.
  template <class Value, class Emit>
  std::optional<Sorted<CudaExecutor, Value>> emit_sorted(std::uint64_t count, int bits,
                                                         std::uint64_t max_pairs, const Emit& emit) const {
    constexpr std::uint64_t rows_per_piece = 32;
    const auto pieces = sums<std::uint64_t>(count + 1, [=] MASU_PASS(std::uint64_t i) {
      const std::uint64_t rows = i != count ? emit.size(i) : 0;
      return (rows + rows_per_piece - 1) / rows_per_piece;
    });
    const std::uint64_t* const first_piece = pieces.data();
    const std::uint64_t piece_count = value(pieces, count);

    const auto pairs = sums<std::uint64_t>(piece_count + 1, [=] MASU_PASS(std::uint64_t piece) {
      std::uint64_t own = 0;
      if (piece != piece_count) {
        const std::uint64_t i = owner_of(first_piece, count, piece);
        const std::uint64_t row = (piece - first_piece[i]) * rows_per_piece;
        emit(i, row, row + rows_per_piece, [&](std::uint64_t, const Value&) { ++own; });
      }
      return own;
    });
    const std::uint64_t* const first_pair = pairs.data();
    const std::uint64_t pair_count = value(pairs, piece_count);
    if (pair_count > max_pairs) return std::nullopt;

    Sorted<CudaExecutor, Value> sorted{array<std::uint64_t>(pair_count), array<Value>(pair_count)};
    std::uint64_t* const keys = sorted.keys.data();
    Value* const values = sorted.values.data();
    for_each(piece_count, [=] MASU_PASS(std::uint64_t piece) {
      const std::uint64_t i = owner_of(first_piece, count, piece);
      const std::uint64_t row = (piece - first_piece[i]) * rows_per_piece;
      std::uint64_t offset = first_pair[piece];
      emit(i, row, row + rows_per_piece, [&](std::uint64_t key, const Value& value) {
        keys[offset] = key;
        values[offset++] = value;
      });
    });
    sort(sorted.keys, sorted.values, bits);
    return sorted;
  }

private:
  template <class T, class Of>
  void sum_by_block(Array<T>& sums, const Of& of) const {
    launch(kernels::sum_by_block<T, Of>, 1, kernels::summing_threads, nullptr, sums.data(),
           static_cast<unsigned>(sums.size()), of);
  }
  template <class Value>
  void sort(Array<std::uint64_t>& keys, Array<Value>& values, int bits) const {
    if (keys.size() == 0) return;
    if constexpr (sizeof(Value) <= sizeof(std::uint64_t)) {
      using namespace kernels;
      if (keys.size() <= max_for_block) {
        launch(sort_by_block<Value>, 1, sorting_threads, nullptr, keys.data(), values.data(),
               static_cast<unsigned>(keys.size()), bits);
        return;
      }
    }
    auto other_keys = array<std::uint64_t>(keys.size());
    auto other_values = array<Value>(values.size());
    cub::DoubleBuffer<std::uint64_t> key_buffers(keys.data(), other_keys.data());
    cub::DoubleBuffer<Value> value_buffers(values.data(), other_values.data());
    with_memory([&](void* memory, std::size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(memory, bytes, key_buffers, value_buffers, keys.size(), 0, bits);
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

  StreamMemory memory_; // the default stream
  const ProgressMonitor* progress_;
  mutable Array<std::uint32_t> arrivals_; // of blocks that join; 0 between kernels
};

} // namespace masu
