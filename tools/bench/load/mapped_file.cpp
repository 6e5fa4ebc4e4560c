#include "tools/bench/load/mapped_file.h"

#include "libscene/base/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace masu {

MappedFile::MappedFile(std::string path) : path_(std::move(path)) {
  const auto fail = [&](const char* doing) {
    throw Error(ErrorCode::input, path_, std::string(doing) + ": " + std::strerror(errno));
  };
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail("can't be opened");
  struct stat status {};
  if (fstat(file, &status) != 0) {
    close(file);
    fail("can't be read");
  }
  if (!S_ISREG(status.st_mode)) {
    close(file);
    throw Error(ErrorCode::input, path_,
                S_ISDIR(status.st_mode) ? "is a directory: name a file"
                                        : "isn't a regular file and can't be mapped: name a file");
  }
  size_ = static_cast<std::size_t>(status.st_size);
  if (size_ > 0) {
    void* const mapping = mmap(nullptr, size_, PROT_READ, MAP_SHARED, file, 0);
    if (mapping == MAP_FAILED) {
      close(file);
      fail("can't be mapped");
    }
    data_ = static_cast<const std::uint8_t*>(mapping);
  }
  close(file);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) munmap(const_cast<std::uint8_t*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : path_(std::move(other.path_)), data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)) {}

} // namespace masu
