#include "libscene/cuda/device_memory.h"
#include "renderer/backend.h"

namespace masu {

void interpolate_cuda(const CornerValues& values, const InterpolatedHits& hits, std::size_t count, int device,
                      void* stream) {
  const DeviceScope scope(device);
  for_each_on_device(count * values.width, static_cast<cudaStream_t>(stream),
                     [=] __device__(std::uint64_t n) {
                       hits.results[n] = interpolated(values, hits, n / values.width, n % values.width);
                     });
}

} // namespace masu
