// Large memory in pages of 2 MiB: a first write to each page of 4 KiB costs as much as filling it does.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>

namespace masu {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;

// How many bytes come before the next one.
inline std::size_t bytes_to_huge_page(const void* begin) {
  return (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
}

// For the whole huge pages among `bytes`.
inline void advise_huge_pages(void* begin, std::size_t bytes, int advice) {
  const std::size_t skipped = bytes_to_huge_page(begin);
  if (bytes < skipped + huge_page) return;
  static_cast<void>(madvise(static_cast<std::uint8_t*>(begin) + skipped,
                            (bytes - skipped) / huge_page * huge_page, advice));
}
inline void prefer_huge_pages(void* begin, std::size_t bytes) {
  advise_huge_pages(begin, bytes, MADV_HUGEPAGE);
}

// So many bytes in mappings of whole huge pages, of which those that are written count as used. Throws
// std::bad_alloc.
inline std::size_t in_whole_huge_pages(std::size_t bytes) {
  return (bytes + huge_page - 1) / huge_page * huge_page;
}
inline void* map_huge_pages(std::size_t bytes) {
  const std::size_t whole = in_whole_huge_pages(bytes);
  void* const mapping =
      mmap(nullptr, whole + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping == MAP_FAILED) throw std::bad_alloc();
  const std::size_t before = bytes_to_huge_page(mapping);
  std::uint8_t* const begin = static_cast<std::uint8_t*>(mapping) + before;
  if (before > 0) munmap(mapping, before);
  munmap(begin + whole, huge_page - before);
  prefer_huge_pages(begin, bytes);
  return begin;
}
inline void unmap_huge_pages(void* begin, std::size_t bytes) {
  munmap(begin, in_whole_huge_pages(bytes));
}

} // namespace masu
