// Rays that a kernel leaves to the next one (CUDA sources only).
//
// Rays are traced in the order of a list. Those that graze a surface take many times as long as most, and
// they lie side by side: the last few warps would keep the others waiting for as long as all the rest took.
// So once the list is drained for one warp, the others leave their rays in a queue. A second kernel deals
// them out to all warps evenly: neighbours part, and idle lanes can help.
#pragma once

#include "renderer/cuda/kernel.h"
#include "renderer/rays/ray_query.h"

namespace masu {

// A ray that was followed to t = from.
template <class Real>
struct Straggler {
  Hit<Real> nearest; // so far
  Real from;
  std::uint32_t number; // in the list
};

// What a kernel's warps exchange. All 0 at first.
struct WarpProgress {
  // Given once the list is drained for a warp. Thousands poll it at every turn: at one address they would
  // queue up.
  struct alignas(128) Signal {
    std::uint32_t given;
  };
  std::uint32_t next_ray; // that no warp has fetched yet
  std::uint32_t left;     // rays
  std::uint32_t culls;    // 1: most rays miss the scene's bounds, and the others are chosen (culling.h)
  std::uint32_t chosen;   // so many rays
  Signal drained[lanes_per_warp];
};

template <class Real>
struct StragglerQueue {
  WarpProgress* progress;
  Straggler<Real>* rays; // room for one a thread
};

// Adds what a warp's lanes add together, and returns the sum before it to all of them. They are all here.
__device__ inline std::uint32_t add_for_warp(std::uint32_t& sum, int added) {
  std::uint32_t before = 0;
  if (threadIdx.x % lanes_per_warp == 0) before = atomicAdd(&sum, static_cast<std::uint32_t>(added));
  return __shfl_sync(all_lanes, before, 0);
}

// Whether the list is drained for any warp, as lane 0 knew a turn ago: the load that poll() begins is
// finished by the next turn.
class DrainSignal {
public:
  // For all lanes of a warp.
  static __device__ void give(WarpProgress& progress) {
    asm volatile("st.relaxed.gpu.u32 [%0], %1;" ::"l"(signal(progress, threadIdx.x)), "r"(1U) : "memory");
  }
  // As poll() found it last. For all lanes of a warp.
  __device__ bool is_drained() const { return __shfl_sync(all_lanes, given_, 0) != 0; }
  __device__ void poll(WarpProgress& progress) {
    if (threadIdx.x % lanes_per_warp != 0) return;
    const std::uint32_t* const word = signal(progress, blockIdx.x);
    asm volatile("ld.relaxed.gpu.u32 %0, [%1];" : "=r"(given_) : "l"(word) : "memory");
  }

private:
  static __device__ std::uint32_t* signal(WarpProgress& progress, unsigned number) {
    return &progress.drained[number % lanes_per_warp].given;
  }
  std::uint32_t given_ = 0;
};

} // namespace masu
