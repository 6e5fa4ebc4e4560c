// Ways that warps with much left to do give to warps that have nothing left (CUDA sources only).
//
// Of rays that the multiprocessors work off in the order of a list, those that graze a surface take many
// times as long as most, and they lie side by side: what a few warps fetched last keeps the others waiting.
// So a warp that has run out waits for a bundle of ways, and one that still has many gives.
//
// A ray of which a way was given is shared. Each warp keeps the nearest hit of the pieces that it walks; the
// last to be done with one has the nearest of all.
#pragma once

#include "renderer/kernel_cuda.h"

#include <cuda/atomic>

namespace masu {

inline constexpr std::uint32_t not_shared = 0xffffffffU;

// Its nearest hit is compared and replaced in one step, as 64 bits: hits of float32 alone fit there.
struct SharedRay {
  std::uint64_t number;  // in the list
  std::uint64_t nearest; // hit_key(); until pieces is 0, of those pieces that are done
  std::uint32_t pieces;  // not done yet
};

// A piece of a shared ray's way, from where to where.
struct PooledWay {
  std::uint32_t ray;
  float from, to;
};

// What a warp gives or takes at once.
struct WayBundle {
  std::uint32_t count; // of ways; 0: not given yet, or taken
  PooledWay ways[lanes_a_warp];
};

// A way is given in so many pieces, but for the one that the giver keeps.
inline constexpr std::uint32_t pieces_of_given_way = 8;
inline constexpr std::uint32_t most_bundles_given = pieces_of_given_way - 1; // by a warp at once

// All 0 when a kernel starts. Bundles that are given and warps that wait meet by number: the n-th to wait
// takes the n-th given.
struct PoolState {
  std::uint64_t given_and_taken; // bundles given, and 2^32 for each warp that waits or has waited
  std::uint32_t finished;        // warps that are done with rays of their own, and bundles
  std::uint32_t blocks;          // that have started
  std::uint64_t next_ray;        // that no warp has fetched yet
};
inline constexpr std::uint64_t one_taken = std::uint64_t{1} << 32;

struct WayPool {
  PoolState* state;
  SharedRay* rays;    // one for each thread
  WayBundle* bundles; // bundle n is at n modulo their number
  std::uint32_t bundle_count;
  std::uint32_t blocks, warps; // in all
  std::int32_t enough;         // must wait, so that it pays to give
};

// Owns what a kernel of so many blocks needs.
class WayPoolMemory {
public:
  // A warp gives after it has seen that more warps waited than bundles were given: so none gives twice before
  // something is taken, and there is room for one gift of each warp, and what it waits for itself.
  WayPoolMemory(std::uint32_t blocks, std::uint32_t warps_a_block)
      : blocks_(blocks), warps_(blocks * warps_a_block), state_(1), rays_(warps_ * lanes_a_warp),
        bundles_(std::size_t{warps_} * (most_bundles_given + 1)) {
    check(cudaMemset(bundles_.data(), 0, bundles_.size() * sizeof(WayBundle)));
  }
  // Before each start. A kernel that has ended has taken all bundles.
  void reset() const { check(cudaMemsetAsync(state_.data(), 0, sizeof(PoolState))); }
  // Of each block one warp waits: so many are enough, and their questions slow nobody.
  WayPool view() const {
    return {state_.data(),
            rays_.data(),
            bundles_.data(),
            static_cast<std::uint32_t>(bundles_.size()),
            blocks_,
            warps_,
            static_cast<std::int32_t>((blocks_ + 1) / 2)};
  }

private:
  std::uint32_t blocks_, warps_;
  DeviceArray<PoolState> state_;
  DeviceArray<SharedRay> rays_;
  DeviceArray<WayBundle> bundles_;
};

template <class T>
using DeviceAtomic = cuda::atomic_ref<T, cuda::thread_scope_device>;

// In the order of is_nearer: t is not negative, so its bits rise with it.
__device__ inline std::uint64_t hit_key(const Hit<float>& hit) {
  return std::uint64_t{__float_as_uint(hit.t)} << 32 | hit.primitive;
}
__device__ inline Hit<float> hit_of(std::uint64_t key) {
  return {__uint_as_float(static_cast<std::uint32_t>(key >> 32)), static_cast<PrimitiveIndex>(key)};
}

// So far.
__device__ inline Hit<float> nearest_of(SharedRay& ray) {
  return hit_of(DeviceAtomic<std::uint64_t>(ray.nearest).load(cuda::memory_order_relaxed));
}

// A piece is done, with this nearest hit. Whether it was the last: then `nearest` is that of all.
__device__ inline bool settle(SharedRay& ray, Hit<float>& nearest) {
  DeviceAtomic<std::uint64_t>(ray.nearest).fetch_min(hit_key(nearest), cuda::memory_order_relaxed);
  if (DeviceAtomic<std::uint32_t>(ray.pieces).fetch_sub(1, cuda::memory_order_acq_rel) != 1) return false;
  nearest = nearest_of(ray);
  return true;
}

// For all threads of a block, before anything else.
__device__ inline void start(const WayPool& pool) {
  if (threadIdx.x == 0)
    DeviceAtomic<std::uint32_t>(pool.state->blocks).fetch_add(1, cuda::memory_order_relaxed);
}

// Lane 0's view of who waits, a few turns old: what is asked for now has come when it is looked at next.
class PoolWatch {
public:
  // Whether enough warps waited when ask() was called last. For all lanes of a warp.
  __device__ bool enough_waited(const WayPool& pool) const {
    const auto waited = static_cast<std::int32_t>(static_cast<std::uint32_t>(seen_ >> 32) -
                                                  static_cast<std::uint32_t>(seen_));
    return __shfl_sync(all_lanes, waited >= pool.enough, 0);
  }
  __device__ void ask(const WayPool& pool) {
    if (threadIdx.x % lanes_a_warp == 0)
      seen_ = DeviceAtomic<std::uint64_t>(pool.state->given_and_taken).load(cuda::memory_order_relaxed);
  }

private:
  std::uint64_t seen_ = 0;
};

// The bundle's way for this lane, if there are as many; the bundle may be given again.
__device__ inline bool take_way(WayBundle& bundle, PooledWay& way) {
  const unsigned lane = threadIdx.x % lanes_a_warp;
  const bool has_way = lane < bundle.count;
  if (has_way) way = bundle.ways[lane];
  __syncwarp();
  if (lane == 0) DeviceAtomic<std::uint32_t>(bundle.count).store(0, cuda::memory_order_release);
  return has_way;
}

// Seldom called, and not inlined, so that these take no registers from what is always done.

// A warp is done with its rays or its bundle, and waits for a bundle if it `waits` at all. nullptr: there
// will be none for it. For all lanes of a warp.
inline __device__ __noinline__ WayBundle* next_bundle(WayPool pool, bool waits) {
  WayBundle* bundle = nullptr;
  if (threadIdx.x % lanes_a_warp == 0) {
    const DeviceAtomic<std::uint64_t> given_and_taken(pool.state->given_and_taken);
    const DeviceAtomic<std::uint32_t> finished(pool.state->finished);
    const auto given = [&] {
      return static_cast<std::uint32_t>(given_and_taken.load(cuda::memory_order_relaxed));
    };
    finished.fetch_add(1, cuda::memory_order_release);
    // A block that has not started may have to wait for this one to end.
    const DeviceAtomic<std::uint32_t> started(pool.state->blocks);
    if (waits && started.load(cuda::memory_order_relaxed) == pool.blocks) {
      const auto number =
          static_cast<std::uint32_t>(given_and_taken.fetch_add(one_taken, cuda::memory_order_relaxed) >> 32);
      WayBundle& own = pool.bundles[number % pool.bundle_count];
      const DeviceAtomic<std::uint32_t> count(own.count);
      while (bundle == nullptr) {
        const std::uint32_t done = finished.load(cuda::memory_order_relaxed);
        if (count.load(cuda::memory_order_relaxed) != 0) {
          bundle = &own;
        } else if (done != pool.warps + given()) {
          __nanosleep(500);
        } else { // nobody is left to give, if nothing was given before the last were done
          cuda::atomic_thread_fence(cuda::memory_order_acquire, cuda::thread_scope_device);
          if (done == pool.warps + given()) break;
        }
      }
      // Not while waiting: it empties the cache that other warps work from.
      cuda::atomic_thread_fence(cuda::memory_order_acquire, cuda::thread_scope_device);
    }
  }
  bundle =
      reinterpret_cast<WayBundle*>(__shfl_sync(all_lanes, reinterpret_cast<unsigned long long>(bundle), 0));
  __syncwarp();
  return bundle;
}

// Gives ways of some of the lanes, `givers`: a lane's is that of the shared `ray`, in pieces of length `step`
// from `from` on, of which the first remains the lane's own and the last ends at `end`. For all lanes of a
// warp.
inline __device__ __noinline__ void give_ways(WayPool pool, unsigned givers, std::uint32_t ray, float from,
                                              float step, float end) {
  const unsigned lane = threadIdx.x % lanes_a_warp;
  constexpr std::uint32_t given = pieces_of_given_way - 1;
  const std::uint32_t ways = given * static_cast<std::uint32_t>(__popc(givers)),
                      bundles = (ways + lanes_a_warp - 1) / lanes_a_warp;
  const bool gives = (givers >> lane & 1) != 0;
  if (gives) DeviceAtomic<std::uint32_t>(pool.rays[ray].pieces).fetch_add(given, cuda::memory_order_relaxed);
  std::uint32_t first = 0;
  if (lane == 0)
    first = static_cast<std::uint32_t>(DeviceAtomic<std::uint64_t>(pool.state->given_and_taken)
                                           .fetch_add(bundles, cuda::memory_order_relaxed));
  first = __shfl_sync(all_lanes, first, 0);
  const auto bundle = [&](std::uint32_t i) -> WayBundle& {
    return pool.bundles[(first + i) % pool.bundle_count];
  };
  if (lane < bundles) { // whoever took what lay there before has read it soon
    const DeviceAtomic<std::uint32_t> count(bundle(lane).count);
    while (count.load(cuda::memory_order_acquire) != 0) {
    }
  }
  __syncwarp();
  if (gives) {
    // Dealt out in turn: neighbouring pieces of a way are as easy or hard as each other.
    std::uint32_t at = given * static_cast<std::uint32_t>(__popc(givers & ((1U << lane) - 1)));
    for (std::uint32_t i = 1; i <= given; ++i, ++at)
      bundle(at % bundles).ways[at / bundles] = {ray, fused(step, static_cast<float>(i), from),
                                                 i < given ? fused(step, static_cast<float>(i + 1), from)
                                                           : end};
  }
  __syncwarp();
  if (lane < bundles)
    DeviceAtomic<std::uint32_t>(bundle(lane).count)
        .store((ways + bundles - 1 - lane) / bundles, cuda::memory_order_release);
}

} // namespace masu
