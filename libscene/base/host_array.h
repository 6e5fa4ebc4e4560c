// Arrays in host memory, of large pages, whose elements aren't written before they are computed.
#pragma once

#include "libscene/base/huge_pages.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace masu {

// Constructs without a value what would else be set to zero.
template <class T>
struct DefaultInitAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = DefaultInitAllocator<U>;
  };
  using std::allocator<T>::allocator;
  T* allocate(std::size_t count) {
    T* const place = std::allocator<T>::allocate(count);
    prefer_huge_pages(place, count * sizeof(T));
    return place;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      ::new (static_cast<void*>(place)) U;
    } else {
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }
  }
};

template <class T>
using HostArray = std::vector<T, DefaultInitAllocator<T>>;

// What an executor (libscene/passes/executor.h) on the host works in.
struct HostMemory {
  template <class T>
  using Array = HostArray<T>;
};

} // namespace masu
