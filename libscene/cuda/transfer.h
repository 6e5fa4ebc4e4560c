// Copies arrays to a CUDA device and back.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "libscene/file/container.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace masu {

// A list of copies that are then made together. The driver copies pageable memory with one thread, far below
// the bandwidth of the bus; a few threads that copy through page-locked memory saturate it. So sections of
// files go from the file to the device, and are nowhere else on the host.
class Transfer {
public:
  // Of the current device. `pool`: of the arrays' memory; null for the device's own.
  explicit Transfer(cudaMemPool_t pool = nullptr);
  void to_device(void* device, const void* host, std::size_t bytes) {
    if (bytes > 0) copies_.push_back({device, host, bytes, cudaMemcpyHostToDevice, nullptr});
  }
  // Part by part, each of which lies on the device until `place` has queued there what takes it to where it
  // belongs.
  using Place = std::function<void(const void* part, std::uint64_t offset, std::size_t bytes, cudaStream_t)>;
  void to_device(Place place, const void* host, std::size_t bytes) {
    if (bytes > 0)
      copies_.push_back({nullptr, host, bytes, cudaMemcpyHostToDevice, nullptr, std::move(place)});
  }
  void to_device(Place place, SectionReader section) {
    to_device(nullptr, std::move(section));
    copies_.back().place = std::move(place);
  }
  void to_host(void* host, const void* device, std::size_t bytes) {
    if (bytes > 0) copies_.push_back({host, device, bytes, cudaMemcpyDeviceToHost, nullptr});
  }
  void to_device(void* device, SectionReader section) {
    auto owned = std::make_shared<SectionReader>(std::move(section));
    copies_.push_back({device, nullptr, owned->bytes(), cudaMemcpyHostToDevice, owned});
  }
  // A device array for so many records; `room` more follow them, all zero.
  template <class T>
  DeviceArray<T> room_for(std::size_t count, std::size_t room = 0) const {
    DeviceArray<T> device(count + room, {nullptr, pool_});
    if (room > 0) check(cudaMemsetAsync(device.data() + count, 0, room * sizeof(T), nullptr));
    return device;
  }
  // Makes the copies, and checks the hashes of sections. Throws Error(device), and Error(input) as
  // SectionReader has it.
  void run();

private:
  struct Copy {
    void* to;
    const void* from; // null: of the section
    std::size_t bytes;
    cudaMemcpyKind direction;
    std::shared_ptr<SectionReader> section;
    Place place{}; // null: to `to`
  };

  std::vector<Copy> copies_;
  int device_ = 0;
  cudaMemPool_t pool_ = nullptr;
};

// From host memory to host memory with many threads: one doesn't copy as fast as the bus does.
void copy_in_parallel(void* to, const void* from, std::size_t bytes);

} // namespace masu
