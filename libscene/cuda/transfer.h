// Copies arrays to a CUDA device and back.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "libscene/file/container.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace masu {

struct StagingOfThreads; // page-locked memory

// A list of copies that are then made together. The driver copies pageable memory with one thread, far below
// the bandwidth of the bus; a few threads that copy through page-locked memory saturate it. So sections of
// files go from the file to the device, and are nowhere else on the host.
class Transfer {
public:
  // Of the current device. `pool`: of the arrays' memory; null for the device's own.
  explicit Transfer(cudaMemPool_t pool = nullptr);
  // Where `place` is given, part by part, each of which lies on the device until `place` has queued there
  // what takes it to where it belongs.
  using Place = std::function<void(const void* part, std::uint64_t offset, std::size_t bytes, cudaStream_t)>;
  struct Copy {
    void* to;
    const void* from; // null: of the section
    std::size_t bytes;
    cudaMemcpyKind direction;
    std::shared_ptr<SectionReader> section;
    Place place{}; // null: to `to`
  };
  void to_device(void* device, const void* host, std::size_t bytes, Place place = {}) {
    if (bytes > 0)
      copies_.push_back({device, host, bytes, cudaMemcpyHostToDevice, nullptr, std::move(place)});
  }
  void to_device(void* device, SectionReader section, Place place = {}) {
    auto owned = std::make_shared<SectionReader>(std::move(section));
    copies_.push_back({device, nullptr, owned->bytes(), cudaMemcpyHostToDevice, owned, std::move(place)});
  }
  void to_host(void* host, const void* device, std::size_t bytes) {
    if (bytes > 0) copies_.push_back({host, device, bytes, cudaMemcpyDeviceToHost, nullptr});
  }
  // A device array for so many records; `room` more follow them, all zero.
  template <class T>
  DeviceArray<T> room_for(std::size_t count, std::size_t room = 0) const {
    DeviceArray<T> device(count + room, {nullptr, pool_});
    if (room > 0) check(cudaMemsetAsync(device.data() + count, 0, room * sizeof(T), nullptr));
    return device;
  }
  // Makes the copies, and checks the hashes of sections. More may follow, through the same page-locked
  // memory. Throws Error(device), and Error(input) as SectionReader has it.
  void run();

private:
  std::vector<Copy> copies_;
  std::shared_ptr<StagingOfThreads> staging_; // of the first large run() on
  int device_ = 0;
  cudaMemPool_t pool_ = nullptr;
};

// Adds the upload of `count` records, which point to the device's from now on; `room` more follow them, all
// zero.
template <class T>
DeviceArray<T> uploaded(const T*& records, std::uint64_t count, Transfer& upload, std::size_t room = 0) {
  DeviceArray<T> array = upload.room_for<T>(count, room);
  upload.to_device(array.data(), records, count * sizeof(T));
  records = array.data();
  return array;
}
// The same of a file's section, which isn't in memory where `records` are null.
template <class T, class File, class Section>
DeviceArray<T> uploaded(const File& file, Section section, const T*& records, std::uint64_t count,
                        Transfer& upload, std::size_t room = 0) {
  if (records != nullptr || count == 0) return uploaded(records, count, upload, room);
  DeviceArray<T> array = upload.room_for<T>(count, room);
  upload.to_device(array.data(), file.template reader<T>(section));
  records = array.data();
  return array;
}

// From host memory to host memory with many threads: one doesn't copy as fast as the bus does.
void copy_in_parallel(void* to, const void* from, std::size_t bytes);

} // namespace masu
