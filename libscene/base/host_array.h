// Arrays in host memory, whose elements aren't written before they are computed. Large ones are in mappings
// of huge pages: filling them and looking things up at random take less time, and memory goes back to the
// system as soon as it isn't used.
#pragma once

#include "libscene/base/huge_pages.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

namespace masu {

inline constexpr std::size_t large_array = 2 * huge_page; // in bytes

// Constructs without a value what would else be set to zero.
template <class T>
struct DefaultInitAllocator : std::allocator<T> {
  using std::allocator<T>::allocator;
  static constexpr auto alignment = std::align_val_t{std::max<std::size_t>(64, alignof(T))}; // a cache line
  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(bytes < large_array ? ::operator new(bytes, alignment) : map_huge_pages(bytes));
  }
  void deallocate(T* place, std::size_t count) {
    if (count * sizeof(T) < large_array)
      ::operator delete(place, alignment);
    else
      unmap_huge_pages(place, count * sizeof(T));
  }
  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
};

template <class T>
using HostArray = std::vector<T, DefaultInitAllocator<T>>;
using HostBytes = HostArray<std::uint8_t>;

// Elements that aren't read again take no memory from now on, as far as they fill huge pages.
template <class T>
void give_back(T* elements, std::size_t count) {
  advise_huge_pages(elements, count * sizeof(T), MADV_DONTNEED);
}

// What an executor (libscene/passes/executor.h) on the host works in.
struct HostMemory {
  template <class T>
  using Array = HostArray<T>;
};

} // namespace masu
