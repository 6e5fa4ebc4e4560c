// A checker (libscene/file/record_checker.h) of records in a device's memory. CUDA sources only.
#pragma once

#include "libscene/cuda/device_memory.h"
#include "libscene/file/record_checker.h"

namespace masu {

namespace kernels {

inline constexpr unsigned checking_threads = 256;

template <class Good>
__global__ void __launch_bounds__(checking_threads)
    find_fault(std::uint64_t count, const __grid_constant__ Good good, std::uint32_t* const found) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * checking_threads + threadIdx.x;
  if (i < count && !good(i)) *found = 1;
}

} // namespace kernels

class DeviceChecker {
public:
  explicit DeviceChecker(const Queue& queue) : queue_(queue), found_(1, queue) {}

  // Waits for the answer.
  template <class Good>
  bool all(std::uint64_t count, const Good& good) const {
    if (count == 0) return true;
    found_.clear();
    launch(kernels::find_fault<Good>,
           static_cast<unsigned>((count + kernels::checking_threads - 1) / kernels::checking_threads),
           kernels::checking_threads, queue_.stream, count, good, found_.data());
    std::uint32_t found = 0;
    found_.download(&found);
    return found == 0;
  }
  DeviceArray<std::uint32_t> zeros(std::uint64_t count) const {
    DeviceArray<std::uint32_t> words(count, queue_);
    words.clear();
    return words;
  }

private:
  Queue queue_;
  DeviceArray<std::uint32_t> found_;
};

} // namespace masu
