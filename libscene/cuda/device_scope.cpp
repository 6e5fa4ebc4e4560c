#include "libscene/cuda/device_memory.h"

#include <cuda.h>

namespace masu {
namespace {

// Of the driver, which the runtime has found: what is linked to it wouldn't start without one.
template <class Function>
Function driver_function(const char* name, unsigned since) {
  void* found = nullptr;
  cudaDriverEntryPointQueryResult result{};
#if CUDART_VERSION >= 12050
  check(cudaGetDriverEntryPointByVersion(name, &found, since, cudaEnableDefault, &result));
#else
  static_cast<void>(since);
  check(cudaGetDriverEntryPoint(name, &found, cudaEnableDefault, &result));
#endif
  if (result != cudaDriverEntryPointSuccess)
    throw Error(ErrorCode::device, "cuda", std::string("the driver has no ") + name + ": try the CPU");
  return reinterpret_cast<Function>(found);
}

struct ContextFunctions {
  decltype(&cuDeviceGet) device = driver_function<decltype(&cuDeviceGet)>("cuDeviceGet", 2000);
  decltype(&cuDevicePrimaryCtxRetain) retain =
      driver_function<decltype(&cuDevicePrimaryCtxRetain)>("cuDevicePrimaryCtxRetain", 7000);
  decltype(&cuDevicePrimaryCtxRelease) release =
      driver_function<decltype(&cuDevicePrimaryCtxRelease)>("cuDevicePrimaryCtxRelease", 11000);
  decltype(&cuCtxPushCurrent) push = driver_function<decltype(&cuCtxPushCurrent)>("cuCtxPushCurrent", 4000);
  decltype(&cuCtxPopCurrent) pop = driver_function<decltype(&cuCtxPopCurrent)>("cuCtxPopCurrent", 4000);
};

const ContextFunctions& driver() {
  static const ContextFunctions functions;
  return functions;
}

void check_driver(CUresult result) {
  if (result != CUDA_SUCCESS)
    throw Error(ErrorCode::device, "cuda",
                "the GPU's context can't be used (" + std::to_string(result) + "): try the CPU");
}

} // namespace

DeviceScope::DeviceScope(int device) {
  check(cudaInitDevice(device, 0, 0)); // the runtime keeps the primary context from here on
  CUdevice handle{};
  CUcontext context{};
  check_driver(driver().device(&handle, device));
  check_driver(driver().retain(&context, handle));
  const CUresult pushed = driver().push(context);
  static_cast<void>(driver().release(handle));
  check_driver(pushed);
}

DeviceScope::~DeviceScope() {
  CUcontext popped{};
  static_cast<void>(driver().pop(&popped));
}

} // namespace masu
