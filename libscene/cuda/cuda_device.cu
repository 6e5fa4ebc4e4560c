#include "libscene/cuda/cuda_device.h"

#include <cuda_runtime.h>

namespace masu {

bool cuda_available(std::string& why) {
  int devices = 0;
  const cudaError_t error = cudaGetDeviceCount(&devices);
  if (error == cudaSuccess && devices > 0) return true;
  why = error == cudaSuccess ? "there is no CUDA device" : cudaGetErrorString(error);
  return false;
}

bool built_with_cuda() {
  return true;
}

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  if (cudaGetDevice(&device) != cudaSuccess || cudaGetDeviceProperties(&properties, device) != cudaSuccess)
    return {};
  return properties.name;
}

} // namespace masu
