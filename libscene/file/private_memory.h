// Memory of this process alone, for the bytes of large files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace masu {

// Zeros until written; in huge pages where the system has them, so that filling it and looking things up in
// it at random take less time than in a mapped file. Only pages that are written count as used memory.
class PrivateMemory {
public:
  PrivateMemory() = default;
  // Throws std::bad_alloc.
  explicit PrivateMemory(std::size_t bytes);

  std::span<std::uint8_t> bytes() { return {begin_, mapping_ != nullptr ? size_ : 0}; }
  std::span<const std::uint8_t> bytes() const { return {begin_, mapping_ != nullptr ? size_ : 0}; }

private:
  struct Unmap {
    std::size_t bytes;
    void operator()(void* mapping) const;
  };
  std::uint8_t* begin_ = nullptr;
  std::size_t size_ = 0;
  std::unique_ptr<void, Unmap> mapping_;
};

} // namespace masu
