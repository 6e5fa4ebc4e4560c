// Memory of this process alone, for the bytes of large files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace masu {

// Zeros until written; in huge pages where the system has them, so that filling it and looking things up in
// it at random take less time than in a mapped file. Only pages that are written count as used memory.
class PrivateMemory {
public:
  PrivateMemory() = default;
  // Throws std::bad_alloc.
  explicit PrivateMemory(std::size_t bytes);
  ~PrivateMemory();
  PrivateMemory(PrivateMemory&& other) noexcept;
  PrivateMemory& operator=(PrivateMemory&& other) noexcept;
  PrivateMemory(const PrivateMemory&) = delete;
  PrivateMemory& operator=(const PrivateMemory&) = delete;

  std::span<std::uint8_t> bytes() { return {begin_, size_}; }
  std::span<const std::uint8_t> bytes() const { return {begin_, size_}; }

private:
  std::uint8_t* begin_ = nullptr;
  std::size_t size_ = 0;
  void* mapping_ = nullptr;
  std::size_t mapping_size_ = 0;
};

} // namespace masu
