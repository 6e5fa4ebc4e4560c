// For builds without CUDA.
#include "libscene/cuda/cuda_device.h"

namespace masu {

bool cuda_available(std::string& why) {
  why = "this program was built without CUDA";
  return false;
}

} // namespace masu
