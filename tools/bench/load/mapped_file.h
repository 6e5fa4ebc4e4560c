// A read-only memory mapping of a whole file: what loading is compared with.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace masu {

class MappedFile {
public:
  // Throws Error(input, path, …): missing, a directory, unreadable. An empty file maps to an empty span.
  explicit MappedFile(std::string path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  MappedFile& operator=(MappedFile&&) = delete;

  std::span<const std::uint8_t> bytes() const { return {data_, size_}; }
  const std::string& path() const { return path_; }

private:
  std::string path_;
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace masu
