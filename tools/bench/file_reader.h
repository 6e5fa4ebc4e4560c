// read(2) of a file from its start to its end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace masu {

class FileReader {
public:
  // Throws Error(input, path, …).
  explicit FileReader(std::string path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader(FileReader&&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  FileReader& operator=(FileReader&&) = delete;

  std::size_t size() const { return size_; } // when it was opened

  // Fills `buffer` with what comes next, or with what is left; returns how much. Throws Error(input, path,
  // …).
  std::size_t read(std::span<std::uint8_t> buffer);

private:
  std::string path_;
  int file_;
  std::size_t size_ = 0;
};

} // namespace masu
