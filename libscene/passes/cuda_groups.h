// Groups of a device's threads (thread_group.h): some of a warp, a block. CUDA sources only.
#pragma once

#include "libscene/base/atomic.h"
#include "libscene/geometry/box.h"

#include <bit>
#include <cstddef>

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
struct ThreadBlock : SharedByThreads<true> {
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

} // namespace masu
