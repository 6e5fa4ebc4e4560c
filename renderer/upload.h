// Bringing files' sections onto a CUDA device. CUDA sources only.
#pragma once

#include "renderer/device_memory.h"

#include <vector>

namespace masu {

// Copies to be made, and then made together. The driver copies from a mapping with one thread, far below what
// the bus carries; a few threads that fill page-locked memory by turns keep the bus busy.
class Upload {
public:
  // With room for so many records more behind, which are all zero.
  template <class T>
  DeviceArray<T> array(std::span<const T> host, std::size_t room = 0) {
    DeviceArray<T> device(host.size() + room);
    if (room > 0) check(cudaMemset(device.data() + host.size(), 0, room * sizeof(T)));
    if (!host.empty()) copies_.push_back({device.data(), host.data(), host.size_bytes()});
    return device;
  }
  // Waits until all is there. Throws Error(device).
  void run();

private:
  struct Copy {
    void* device;
    const void* host;
    std::size_t bytes;
  };
  std::vector<Copy> copies_;
};

} // namespace masu
