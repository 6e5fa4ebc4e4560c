// For builds without CUDA.
#include "libscene/cuda/cuda_device.h"

namespace masu {

bool cuda_available(std::string& why) {
  why = "this program was built without CUDA";
  return false;
}

bool built_with_cuda() {
  return false;
}

std::string cuda_device_name() {
  return {};
}

} // namespace masu
