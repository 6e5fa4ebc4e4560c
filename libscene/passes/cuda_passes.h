// The kernels of passes on a CUDA device (cuda_executor.h), and their groups of threads (thread_group.h):
// some of a warp, a block. CUDA sources only.
#pragma once

#include "libscene/base/atomic.h"
#include "libscene/cuda/warp.h"
#include "libscene/geometry/box.h"

#include <cub/block/block_radix_sort.cuh>
#include <cub/block/block_scan.cuh>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace masu {

// What a group's threads share. Of many boxes few change the one that all share: where `looks_first`, the
// others don't wait for their turns.
template <bool looks_first>
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
    if (looks_first && !(value < least)) return;
    if (value + 0 >= 0)
      atomicMin(reinterpret_cast<int*>(&least), __float_as_int(value + 0));
    else
      atomicMax(reinterpret_cast<unsigned*>(&least), __float_as_uint(value));
  }
  __device__ static void raise(float& most, float value) {
    if (looks_first && !(value > most)) return;
    if (value + 0 >= 0)
      atomicMax(reinterpret_cast<int*>(&most), __float_as_int(value + 0));
    else
      atomicMin(reinterpret_cast<unsigned*>(&most), __float_as_uint(value));
  }
};

// Some of a warp's threads, `width` (a power of two) side by side, as thread_group.h has them.
template <unsigned width>
struct WarpTile : SharedByThreads<false> {
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
  __device__ std::uint32_t ballot(bool is) const {
    return __ballot_sync(all(), is) >> threadIdx.x % 32 / width * width;
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
    return from_lane(own, static_cast<int>(other), all(), width);
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
struct ThreadBlock : SharedByThreads<true> {
  __device__ std::uint32_t thread_rank() const { return threadIdx.x; }
  __device__ std::uint32_t size() const { return blockDim.x; }
  __device__ void sync() const { __syncthreads(); }
  template <unsigned width>
  __device__ WarpTile<width> tile() const {
    return {};
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
  __device__ std::uint32_t sum_of_warps_before(std::uint32_t of_warp, std::uint32_t& all) const {
    constexpr unsigned warp = 32;
    __shared__ std::uint32_t of_warps[warp];
    __syncthreads(); // the last call's have been read
    if (threadIdx.x % warp == 0) of_warps[threadIdx.x / warp] = of_warp;
    __syncthreads();
    std::uint32_t before = 0;
    all = 0;
    for (unsigned k = 0; k < blockDim.x / warp; ++k) {
      if (k == threadIdx.x / warp) before = all;
      all += of_warps[k];
    }
    return before;
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

// Each block joins its share; the last to come joins what they have left. `arrivals`: 0.
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

// So few are summed up by one block, piece by piece, sooner than by CUB's kernels.
inline constexpr unsigned summing_threads = 512, summed_by_thread = 8,
                          summed_at_once = summing_threads * summed_by_thread,
                          max_summed_by_block = 2 * summed_at_once;
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
    Scan(memory).ExclusiveSum(own, own, all);
    for (unsigned k = 0; k < summed_by_thread; ++k)
      if (first + k < count) sums[first + k] = before + own[k];
    before = before + all;
    __syncthreads(); // the memory has been read
  }
}

// A piece of what is emitted (CudaExecutor::emit_sorted): some rows of an item, so that threads share a large
// one; all of one without size().
template <class Emit>
struct EmittedPieces {
  static constexpr std::uint64_t rows_per_piece = 32;
  Emit emit;
  const std::uint64_t* first_piece; // of so many items
  std::uint64_t items;

  __device__ std::uint64_t of_item(std::uint64_t i) const {
    return i != items ? (emit.size(i) + rows_per_piece - 1) / rows_per_piece : 0;
  }
  template <class Add>
  __device__ void operator()(std::uint64_t piece, const Add& add) const {
    if constexpr (has_size<Emit>) {
      const std::uint64_t i = owner_of(first_piece, items, piece),
                          row = (piece - first_piece[i]) * rows_per_piece;
      emit(i, row, row + rows_per_piece, add);
    } else {
      emit(piece, 0, 1, add);
    }
  }
};

} // namespace kernels

} // namespace masu
