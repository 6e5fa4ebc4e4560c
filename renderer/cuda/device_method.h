// Methods as kernels have them, and the sums of what their threads count. CUDA sources only.
#pragma once

#include "libgrid/trace/trace.h"
#include "renderer/counts.h"
#include "renderer/cuda/kernel.h"

namespace masu {

__device__ inline void add(Counts* total, const Counts& part) {
  if (total == nullptr) return;
  for_each_count(*total, part, [](std::uint64_t& sum, std::uint64_t count) {
    if (count != 0) atomicAdd(reinterpret_cast<unsigned long long*>(&sum), count);
  });
}
__device__ inline void add(Counts*, const NoCounts&) {}

// The method as kernels have it. The same bits, but where there are cones, whose test leaves no registers for
// the plane across the ray, each triangle's test finds that for itself.
template <class M>
struct DeviceMethod {
  using type = M;
};
template <unsigned kinds>
requires((kinds & with_cones) != 0) struct DeviceMethod<Method<WatertightRay<float>, kinds>> {
  using type = Method<PreparedRay<float>, kinds>;
};
template <class M>
using OnDevice = typename DeviceMethod<M>::type;

} // namespace masu
