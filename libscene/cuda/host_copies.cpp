#include "libscene/cuda/host_copies.h"

#include "libscene/cuda/device_memory.h"
#include "libscene/cuda/device_scope.h"

namespace masu {

void copy_to_host(void* to, const void* from, std::size_t bytes, int device) {
  const DeviceScope scope(device);
  check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost));
}

} // namespace masu
