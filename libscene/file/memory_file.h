// A file in memory, gone with its object or its process.
#pragma once

#include <string>

namespace masu {

class MemoryFile {
public:
  // Throws Error(output) where the system has none to give.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  // By which this process alone opens it, for writing (output_file.h) and for mapping.
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
  int file_;
};

} // namespace masu
