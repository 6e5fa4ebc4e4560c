// An anonymous file in memory (memfd), removed with its object.
#pragma once

#include <string>

namespace masu {

class MemoryFile {
public:
  // Throws Error(output) when the system can't create one.
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  // Valid in this process only; for OutputFile and InputFile.
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
  int file_;
};

} // namespace masu
