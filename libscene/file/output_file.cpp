#include "libscene/file/output_file.h"

#include "libscene/base/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace masu {
namespace {

int open_folder(const std::string& folder) {
  const char* const path = folder.empty() ? "." : folder.c_str();
  const int opened = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // A folder that may be written but not read: it can't be flushed, but names in it can be made.
  return opened < 0 && errno == EACCES ? open(path, O_PATH | O_DIRECTORY | O_CLOEXEC) : opened;
}

// Whether `path` leads to the file by name. It doesn't for /proc/self/fd/N of an unnamed or removed file.
bool has_name(const struct stat& file, const std::string& path) {
  struct stat found {};
  return stat(followed(path).c_str(), &found) == 0 && is_same_file(found, file);
}

void copy_owner_and_permissions(const struct stat& from, int to) {
  constexpr uid_t unchanged = ~uid_t{0};
  [[maybe_unused]] const bool done =
      fchown(to, from.st_uid, from.st_gid) == 0 || fchown(to, unchanged, from.st_gid) == 0;
  static_cast<void>(fchmod(to, from.st_mode & 0777U));
}

} // namespace

bool write_all_at(int file, std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return true;
}

void write_text_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

bool is_standard_output(std::string_view path) {
  return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

std::string followed(const std::string& path) {
  constexpr int max_links = 40; // the kernel's limit
  std::filesystem::path current = path;
  for (int links = 0; links <= max_links; ++links) {
    std::error_code is_no_link;
    const std::filesystem::path target = std::filesystem::read_symlink(current, is_no_link);
    if (is_no_link) return current.string();
    current = current.parent_path() / target; // an absolute target replaces the path
  }
  throw Error(ErrorCode::output, path, "leads through too many symbolic links: name the file itself");
}

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat a_status {
  }, b_status{};
  const bool a_exists = stat(a.c_str(), &a_status) == 0, a_is_loop = !a_exists && errno == ELOOP;
  const bool b_exists = stat(b.c_str(), &b_status) == 0, b_is_loop = !b_exists && errno == ELOOP;
  if (a_exists != b_exists || a_is_loop || b_is_loop) return false;
  if (a_exists) return S_ISREG(a_status.st_mode) && is_same_file(a_status, b_status);
  const std::filesystem::path a_target = followed(a), b_target = followed(b);
  const auto folder_of = [](const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  };
  std::error_code missing;
  return a_target.filename() == b_target.filename() &&
         std::filesystem::equivalent(folder_of(a_target), folder_of(b_target), missing) && !missing;
}

OutputFile::OutputFile(std::string path, UntilCommit until_commit) : path_(std::move(path)) {
  if (path_.empty()) throw Error(ErrorCode::output, "output", "has no name: give a file");
  if (is_standard_output(path_)) {
    path_ = "standard output";
    if (std::fflush(stdout) != 0) fail("can't be written");
    const int copy = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
    if (copy < 0 || (stream_ = fdopen(copy, "wb")) == nullptr) fail("can't be written");
    return;
  }
  struct stat status {};
  const bool exists = stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw Error(ErrorCode::output, path_, "is a directory: name a file");
  int file = -1;
  if (exists && (!S_ISREG(status.st_mode) || !has_name(status, path_))) {
    file = open(path_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  } else {
    if (exists && access(path_.c_str(), W_OK) != 0) fail("can't be written"); // rename doesn't check
    file = open_in_folder(until_commit);
    if (file >= 0 && exists) copy_owner_and_permissions(status, file);
  }
  if (file >= 0) stream_ = fdopen(file, "wb");
  if (stream_ != nullptr) return;
  const int reason = errno;
  if (file >= 0) close(file);
  close_all();
  errno = reason;
  fail("can't be created");
}

// Returns -1 and sets errno when it fails.
int OutputFile::open_in_folder(UntilCommit until_commit) {
  const std::filesystem::path target = followed(path_);
  name_ = target.filename().string();
  folder_ = open_folder(target.parent_path().string());
  if (folder_ < 0) return -1;
  // An impossible name (too long, say) fails now, not at commit.
  struct stat status {};
  if (fstatat(folder_, name_.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 &&
      (errno != ENOENT || name_.empty()))
    return -1;
  const int unnamed = until_commit == UntilCommit::unnamed ? open_unnamed() : -1;
  if (unnamed >= 0) {
    TemporaryName(folder_, name_).remove_left();
    return unnamed;
  }
  return temporary_.emplace(folder_, name_).create();
}

// Returns -1 when the file system has no unnamed files, or they couldn't be linked later (no /proc).
int OutputFile::open_unnamed() const {
  const int file = openat(folder_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0 || access(fmt::format("/proc/self/fd/{}", file).c_str(), F_OK) == 0) return file;
  close(file);
  return -1;
}

void OutputFile::write(const void* data, std::size_t bytes) {
  if (bytes > 0 && std::fwrite(data, 1, bytes, stream_) != bytes) fail("can't be written");
}

void OutputFile::write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
  if (!write_all_at(fileno(stream_), offset, bytes)) fail("can't be written");
}

std::string OutputFile::temporary_path() const {
  if (!temporary_) throw Error(ErrorCode::output, path_, "isn't a regular file: name a file");
  return (std::filesystem::path(followed(path_)).parent_path() / temporary_->name()).string();
}

void OutputFile::rewind() {
  if (fseeko(stream_, 0, SEEK_SET) != 0) fail("can't be written from its start");
}

void OutputFile::commit() {
  if (std::ferror(stream_) != 0 || std::fflush(stream_) != 0) fail("can't be written");
  if (folder_ < 0) { // written directly: no name to give, and flushing may not be possible
    if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail("can't be written");
    return;
  }
  if (fsync(fileno(stream_)) != 0) fail("can't be flushed");
  if (!give_name()) fail("can't be given its name");
  if (fsync(folder_) != 0 && errno != EINVAL && errno != EBADF) fail("can't be flushed in its folder");
  close_all();
}

bool OutputFile::give_name() {
  if (!temporary_) {
    const std::string unnamed = fmt::format("/proc/self/fd/{}", fileno(stream_));
    if (linkat(AT_FDCWD, unnamed.c_str(), folder_, name_.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
    if (errno != EEXIST || !temporary_.emplace(folder_, name_).link(fileno(stream_))) return false;
  }
  return temporary_->rename_to(name_);
}

// The temporary name must be removed before the file is closed and so unlocked.
void OutputFile::close_all() {
  temporary_.reset();
  if (stream_ != nullptr) static_cast<void>(std::fclose(std::exchange(stream_, nullptr)));
  if (folder_ >= 0) close(std::exchange(folder_, -1));
}

void OutputFile::fail(const char* doing) const {
  throw Error(ErrorCode::output, path_, std::string(doing) + ": " + std::strerror(errno));
}

} // namespace masu
