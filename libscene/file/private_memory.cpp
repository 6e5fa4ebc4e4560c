#include "libscene/file/private_memory.h"

#include "libscene/base/huge_pages.h"

#include <sys/mman.h>

#include <limits>
#include <new>

namespace masu {

PrivateMemory::PrivateMemory(std::size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  const std::size_t alignment = bytes >= huge_page ? huge_page : 0;
  if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
  void* const mapping =
      mmap(nullptr, bytes + alignment, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping == MAP_FAILED) throw std::bad_alloc();
  mapping_ = std::unique_ptr<void, Unmap>(mapping, Unmap{bytes + alignment});
  begin_ = static_cast<std::uint8_t*>(mapping);
  if (alignment > 0) begin_ += (alignment - reinterpret_cast<std::uintptr_t>(begin_) % alignment) % alignment;
  prefer_huge_pages(begin_, bytes);
}

void PrivateMemory::Unmap::operator()(void* mapping) const {
  munmap(mapping, bytes);
}

} // namespace masu
