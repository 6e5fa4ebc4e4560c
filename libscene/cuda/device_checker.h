// A checker (libscene/file/record_checker.h) of records in a device's memory. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "libscene/file/record_checker.h"

namespace masu {

class DeviceChecker {
public:
  explicit DeviceChecker(const StreamMemory& memory) : memory_(memory), found_(1, memory) {}

  // Waits for the result.
  template <class Good>
  bool all(std::uint64_t count, const Good& good) const {
    if (count == 0) return true;
    found_.clear();
    std::uint32_t* const fault = found_.data();
    for_each_on_device(count, memory_.stream, [=] __device__(std::uint64_t i) {
      if (!good(i)) *fault = 1;
    });
    std::uint32_t found = 0;
    found_.download(&found);
    return found == 0;
  }
  DeviceArray<std::uint32_t> zeros(std::uint64_t count) const {
    DeviceArray<std::uint32_t> words(count, memory_);
    words.clear();
    return words;
  }

private:
  StreamMemory memory_;
  DeviceArray<std::uint32_t> found_;
};

} // namespace masu
