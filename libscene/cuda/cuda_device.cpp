#include "libscene/cuda/cuda_device.h"

#include "libscene/cuda/device_memory.h"

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

int cuda_device_count() {
  int devices = 0;
  return cudaGetDeviceCount(&devices) == cudaSuccess ? devices : 0;
}

int device_of(const void* pointer) {
  const cudaPointerAttributes attributes = attributes_of(pointer);
  const bool on_device = attributes.type == cudaMemoryTypeDevice || attributes.type == cudaMemoryTypeManaged;
  return on_device ? attributes.device : host_memory;
}

void wait_for_stream(void* stream, int device) {
  const DeviceScope scope(device);
  check(cudaStreamSynchronize(static_cast<cudaStream_t>(stream)));
}

void copy_to_host(void* to, const void* from, std::size_t bytes, int device) {
  const DeviceScope scope(device);
  check(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost));
}

std::string cuda_device_name() {
  int device = 0;
  cudaDeviceProp properties{};
  if (cudaGetDevice(&device) != cudaSuccess || cudaGetDeviceProperties(&properties, device) != cudaSuccess)
    return {};
  return properties.name;
}

} // namespace masu
