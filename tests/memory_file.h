// An anonymous file in memory (memfd), removed with its object.
#pragma once

#include "libscene/base/error.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace masu {

class MemoryFile {
public:
  // Throws Error(output) when the system can't create one.
  MemoryFile() : file_(memfd_create("masu", MFD_CLOEXEC)) {
    if (file_ < 0)
      throw Error(ErrorCode::output, "memory", std::string("can't be created: ") + std::strerror(errno));
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  // Valid in this process only; for OutputFile and InputFile.
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

private:
  int file_;
};

} // namespace masu
