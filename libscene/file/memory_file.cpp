#include "libscene/file/memory_file.h"

#include "libscene/base/error.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace masu {

MemoryFile::MemoryFile() : file_(memfd_create("masu", MFD_CLOEXEC)) {
  if (file_ < 0)
    throw Error(ErrorCode::output, "memory", std::string("can't be created: ") + std::strerror(errno));
}

MemoryFile::~MemoryFile() {
  close(file_);
}

} // namespace masu
