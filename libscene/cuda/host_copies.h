// A caller's arrays in host memory: those that lie on a GPU are copied.
#pragma once

#include "libscene/cuda/cuda_device.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace masu {

// Keeps the copies.
class HostCopies {
public:
  template <class T>
  const T* of(const T* array, std::size_t count) {
    const int device = count > 0 && array != nullptr ? device_of(array) : host_memory;
    if (device == host_memory) return array;
    auto copy = std::make_unique_for_overwrite<T[]>(count);
    copy_to_host(copy.get(), array, count * sizeof(T), device);
    const T* const on_host = copy.get();
    copies_.emplace_back(std::move(copy));
    return on_host;
  }

private:
  std::vector<std::shared_ptr<const void>> copies_;
};

} // namespace masu
