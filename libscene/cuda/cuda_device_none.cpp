// For builds without CUDA.
#include "libscene/cuda/cuda_device.h"

#include <cstring>

namespace masu {

bool cuda_available(std::string& why) {
  why = "this program was built without CUDA";
  return false;
}

bool built_with_cuda() {
  return false;
}

int cuda_device_count() {
  return 0;
}

int device_of(const void*) {
  return host_memory;
}

void wait_for_stream(void*, int) {}

void copy_to_host(void* to, const void* from, std::size_t bytes, int) {
  std::memcpy(to, from, bytes);
}

std::string cuda_device_name() {
  return {};
}

} // namespace masu
