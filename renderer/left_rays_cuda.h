// Rays that a kernel leaves to the next one (CUDA sources only).
//
// Of rays that are worked off in the order of a list, those that graze a surface take many times as long as
// most, and they lie side by side: the last few warps would keep the others waiting for as long as all the
// rest took. So once half of the warps have run out of rays, the others leave theirs, and a second kernel
// deals them out to all warps evenly: few to each, so that most of its lanes can help.
#pragma once

#include "renderer/kernel_cuda.h"

namespace masu {

// A ray that was followed to t = from.
template <class Real>
struct LeftRay {
  Hit<Real> nearest; // so far
  Real from;
  std::uint32_t number; // in the list
};

// What a kernel's warps tell each other. All 0 at first.
struct WarpProgress {
  // Thousands of warps ask at every turn whether to leave their rays: at one place in memory they would queue
  // up.
  struct alignas(128) Signal {
    std::uint32_t given;
  };
  std::uint64_t next_ray; // that no warp has fetched yet
  std::uint32_t run_out;  // warps that have no ray any more
  std::uint32_t left;     // rays
  Signal leave[lanes_a_warp];
};

template <class Real>
struct LeftRays {
  WarpProgress* progress;
  LeftRay<Real>* rays; // room for one a thread
};

// Owns what a kernel of so many warps leaves.
template <class Real>
class LeftRaysMemory {
public:
  explicit LeftRaysMemory(std::uint32_t warps) : progress_(1), rays_(std::size_t{warps} * lanes_a_warp) {}
  // Before each start.
  void reset() const { check(cudaMemsetAsync(progress_.data(), 0, sizeof(WarpProgress))); }
  LeftRays<Real> view() const { return {progress_.data(), rays_.data()}; }

private:
  DeviceArray<WarpProgress> progress_;
  DeviceArray<LeftRay<Real>> rays_;
};

// Adds what a warp's lanes add together, and returns the sum before it to all of them. They are all here.
template <class T>
__device__ inline T add_for_warp(T& sum, int added) {
  T before = 0;
  if (threadIdx.x % lanes_a_warp == 0)
    before = DeviceAtomic<T>(sum).fetch_add(static_cast<T>(added), cuda::memory_order_relaxed);
  return __shfl_sync(all_lanes, before, 0);
}

// Told by each of `warps` that has no ray any more: by the one in the middle, the others learn to leave theirs.
__device__ inline void tell_run_out(WarpProgress& progress, std::uint32_t warps) {
  if (add_for_warp(progress.run_out, 1) + 1 == (warps + 1) / 2)
    DeviceAtomic<std::uint32_t>(progress.leave[threadIdx.x % lanes_a_warp].given)
        .store(1, cuda::memory_order_relaxed);
}

// Whether a warp is to leave its rays, as lane 0 knew a turn ago: what is asked for now has come when it is
// looked at next.
class LeaveWatch {
public:
  // As ask() found it last. For all lanes of a warp.
  __device__ bool leaves() const { return __shfl_sync(all_lanes, given_, 0) != 0; }
  __device__ void ask(WarpProgress& progress) {
    if (threadIdx.x % lanes_a_warp == 0)
      given_ = DeviceAtomic<std::uint32_t>(progress.leave[blockIdx.x % lanes_a_warp].given)
                   .load(cuda::memory_order_relaxed);
  }

private:
  std::uint32_t given_ = 0;
};

} // namespace masu
