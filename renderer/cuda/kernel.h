// How kernels are sized and launched. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "renderer/picture_warps.h"
#include "renderer/tracing_rules.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace masu {

// A warp may read so many references beyond a list's end, to no effect: their array is longer by them.
inline constexpr std::size_t references_read_ahead = lanes_per_warp - 1;

// Threads that should fit on a multiprocessor: the compiler may spend registers only so far. Double takes
// twice as many.
template <class M>
constexpr int resident_threads_wanted = sizeof(typename M::Real) == 4 ? 1024 : 512;

// Has a kernel's code on the device from now on, so that no launch waits for it, and returns its registers
// and local memory.
template <class Kernel>
KernelSize load(Kernel* kernel) {
  cudaFuncAttributes attributes;
  check(cudaFuncGetAttributes(&attributes, kernel));
  return {attributes.numRegs, static_cast<std::int32_t>(attributes.localSizeBytes)};
}

// How many blocks of so many threads run at once: `each` on a multiprocessor, or for 0 as many as fit.
template <class Kernel>
std::uint32_t resident_blocks(Kernel* kernel, int threads, int each) {
  int device = 0, multiprocessors = 0, fitting = 0;
  check(cudaGetDevice(&device));
  check(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device));
  check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&fitting, kernel, threads, 0));
  return static_cast<std::uint32_t>(multiprocessors * std::max(each > 0 ? each : fitting, 1));
}

// Kernels' attributes, cached: to query them takes longer than a launch. For threads at the same time.
class KernelCache {
public:
  struct Attributes {
    KernelSize size;
    std::uint32_t blocks; // of so many threads that are resident at once
  };
  template <class Kernel>
  Attributes of(Kernel* kernel, int threads) {
    const auto* const key = reinterpret_cast<const void*>(kernel);
    const std::lock_guard lock(mutex_);
    for (const auto& [cached, attributes] : all_)
      if (cached == key) return attributes;
    all_.push_back({key, {load(kernel), resident_blocks(kernel, threads, 0)}});
    return all_.back().second;
  }

private:
  std::mutex mutex_;
  std::vector<std::pair<const void*, Attributes>> all_;
};

} // namespace masu
