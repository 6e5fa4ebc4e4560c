#include "libscene/output_file.h"

#include "libscene/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace masu {

OutputFile::OutputFile(std::string path) : path_(std::move(path)), final_path_(path_), written_path_(path_) {
  if (path_.empty()) throw Error(ErrorCode::output, "output", "has no name: give a file");
  struct stat status {};
  const bool exists = stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw Error(ErrorCode::output, path_, "is a directory: name a file");
  if (!exists || S_ISREG(status.st_mode)) {
    // What the renaming would replace must be writable itself.
    if (exists && access(path_.c_str(), W_OK) != 0) fail("can't be written");
    // A symbolic link stays: what it leads to is replaced.
    if (exists) final_path_ = std::filesystem::canonical(path_).string();
    written_path_ = final_path_ + ".tmp-" + std::to_string(getpid());
  }
  stream_ = std::fopen(written_path_.c_str(), "wbe");
  if (stream_ == nullptr) fail("can't be created");
}

OutputFile::~OutputFile() {
  if (stream_ == nullptr) return;
  static_cast<void>(std::fclose(stream_));
  if (written_path_ != path_) unlink(written_path_.c_str());
}

void OutputFile::write(std::span<const std::uint8_t> bytes) {
  write(bytes.data(), bytes.size());
}

void OutputFile::write(const void* data, std::size_t bytes) {
  if (bytes > 0 && std::fwrite(data, 1, bytes, stream_) != bytes) fail("can't be written");
}

void OutputFile::commit() {
  if (std::fflush(stream_) != 0) fail("can't be written");
  if (written_path_ == path_) {
    // A pipe or a device: nothing to rename, and syncing it may not be possible.
    if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail("can't be written");
    return;
  }
  if (fsync(fileno(stream_)) != 0) fail("can't be flushed");
  if (std::rename(written_path_.c_str(), final_path_.c_str()) != 0) fail("can't be given its name");
  static_cast<void>(std::fclose(std::exchange(stream_, nullptr)));
}

void OutputFile::fail(const char* doing) const {
  throw Error(ErrorCode::output, path_, std::string(doing) + ": " + std::strerror(errno));
}

} // namespace masu
