// Large memory in pages of 2 MiB: a first write to each page of 4 KiB costs as much as filling it does.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace masu {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;

// A hint, for the whole huge pages among `bytes`.
inline void prefer_huge_pages(void* begin, std::size_t bytes) {
  const std::size_t skipped = (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
  if (bytes < skipped + huge_page) return;
  static_cast<void>(madvise(static_cast<std::uint8_t*>(begin) + skipped,
                            (bytes - skipped) / huge_page * huge_page, MADV_HUGEPAGE));
}

} // namespace masu
