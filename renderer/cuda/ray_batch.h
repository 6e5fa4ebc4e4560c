// Queries of rays and pictures in a CUDA device's memory, put on a stream. CUDA sources only.
#pragma once

#include "renderer/cuda/device_files.h"

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
using OnDevice = std::conditional_t<std::is_same_v<typename M::TestRay, WatertightRay<float>> &&
                                        (M::kinds & with_cones) != 0,
                                    Method<PreparedRay<float>, M::kinds>, M>;

// A list of rays in device memory, in the arithmetic's numbers, on its way through a stream.
template <class Real>
struct RayBatch {
  const Ray<Real>* rays;
  std::uint64_t count;
  RayResults results; // nearest_hit: t and primitive are there if there are attributes or names to find
  Counts* counts;     // null: not counted
  StreamMemory memory;
  cudaEvent_t begun; // recorded before the first kernel; may be null

  void begin() const {
    if (begun != nullptr) check(cudaEventRecord(begun, memory.stream));
  }
};

// For each arithmetic and store: render_float.cu, rays_float.cu, …. Throw Error(device).
template <class TestRay, class Stored>
void render_on_device(const DeviceFiles& device_files, const FrameRequest& request, FrameBuffers& buffers,
                      Frame& frame);
// The picture's pixels of the radiance along all its rays.
void launch_bytes(const Vec3f* radiance, std::int32_t columns, Sampling sampling,
                  const DeviceArray<std::uint8_t>& rgb, cudaStream_t stream);
// Of placed meshes: with names and attributes; not by `fast`.
template <class TestRay, class Stored>
KernelSize launch_placed(const DeviceFilesOf<Stored>& files, const RayList& list, const RaysRequest& request,
                         const RayBatch<typename TestRay::Real>& batch, const RayResults& results);

// Puts a query of rays, one or more, in the memory of the files' device, the current one, on a stream. Counts
// are added to `counts` there, where that isn't null. `begun`, where it isn't null, is recorded when memory
// is there and the kernels come. Throws Error(device).
using LaunchRays = KernelSize(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                              const RaysRequest& request, Counts* counts, cudaStream_t stream,
                              cudaEvent_t begun);
template <class TestRay, class Stored>
LaunchRays launch_list;    // rays_float.cu, rays_double.cu
LaunchRays launch_closest; // of places, whichever store and structure; nothing is counted
LaunchRays* launcher_of(const DeviceFiles& files, const RaysRequest& request);

} // namespace masu
