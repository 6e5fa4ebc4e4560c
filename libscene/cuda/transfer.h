// Copies arrays to a CUDA device and back. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"

#include <functional>
#include <vector>

namespace masu {

// A list of copies that are then made together. The driver copies pageable memory with one thread, far below
// the bandwidth of the bus; a few threads that copy through page-locked memory saturate it.
class Transfer {
public:
  // Of the current device.
  Transfer();
  void to_device(void* device, const void* host, std::size_t bytes) {
    if (bytes > 0) copies_.push_back({device, host, bytes, cudaMemcpyHostToDevice});
  }
  void to_host(void* host, const void* device, std::size_t bytes) {
    if (bytes > 0) copies_.push_back({host, device, bytes, cudaMemcpyDeviceToHost});
  }
  // Allocates a device array and adds its upload; `room` more records follow it, all zero.
  template <class T>
  DeviceArray<T> array(std::span<const T> host, std::size_t room = 0) {
    DeviceArray<T> device(host.size() + room);
    if (room > 0) check(cudaMemset(device.data() + host.size(), 0, room * sizeof(T)));
    to_device(device.data(), host.data(), host.size_bytes());
    return device;
  }
  // Makes the copies while it calls meanwhile(); returns when both are done. Throws Error(device) and what
  // meanwhile() throws.
  void run(const std::function<void()>& meanwhile = [] {});

private:
  void copy_all();

  struct Copy {
    void* to;
    const void* from;
    std::size_t bytes;
    cudaMemcpyKind direction;
  };
  std::vector<Copy> copies_;
  int device_ = 0;
};

} // namespace masu
