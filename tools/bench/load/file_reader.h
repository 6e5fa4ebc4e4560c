// Sequential reading of a file by read(2).
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

  // Reads the next bytes into `buffer`: all of it, or up to the file's end. Returns their number. Throws
  // Error(input, path, …).
  std::size_t read(std::span<std::uint8_t> buffer);

private:
  std::string path_;
  int file_;
  std::size_t size_ = 0;
};

} // namespace masu
