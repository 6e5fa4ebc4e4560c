// Placed meshes on a CUDA device. CUDA sources only.
#pragma once

#include "libgrid/placed/place_passes.h"
#include "libscene/passes/cuda_executor.h"
#include "renderer/cuda/device_scene.h"

namespace masu {

template <class Stored>
struct PlacedOnDevice {
  SharedArrays parts_memory; // of what doesn't move
  std::shared_ptr<const CudaExecutor> executor;
  PlacedArrays<CudaExecutor, Stored> arrays;
};

} // namespace masu
