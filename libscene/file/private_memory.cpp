#include "libscene/file/private_memory.h"

#include <sys/mman.h>

#include <limits>
#include <new>
#include <utility>

namespace masu {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

} // namespace

PrivateMemory::PrivateMemory(std::size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  const std::size_t alignment = bytes >= huge_page ? huge_page : 0;
  if (bytes > std::numeric_limits<std::size_t>::max() - alignment) throw std::bad_alloc();
  mapping_size_ = bytes + alignment;
  mapping_ = mmap(nullptr, mapping_size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping_ == MAP_FAILED) throw std::bad_alloc();
  begin_ = static_cast<std::uint8_t*>(mapping_);
  if (alignment == 0) return;
  begin_ += (alignment - reinterpret_cast<std::uintptr_t>(begin_) % alignment) % alignment;
  static_cast<void>(madvise(begin_, bytes, MADV_HUGEPAGE)); // a hint
}

PrivateMemory::~PrivateMemory() {
  if (mapping_ != nullptr) munmap(mapping_, mapping_size_);
}

PrivateMemory::PrivateMemory(PrivateMemory&& other) noexcept
    : begin_(std::exchange(other.begin_, nullptr)), size_(std::exchange(other.size_, 0)),
      mapping_(std::exchange(other.mapping_, nullptr)), mapping_size_(std::exchange(other.mapping_size_, 0)) {
}

PrivateMemory& PrivateMemory::operator=(PrivateMemory&& other) noexcept {
  std::swap(begin_, other.begin_);
  std::swap(size_, other.size_);
  std::swap(mapping_, other.mapping_);
  std::swap(mapping_size_, other.mapping_size_);
  return *this;
}

} // namespace masu
