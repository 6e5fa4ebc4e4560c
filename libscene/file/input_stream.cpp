#include "libscene/file/input_stream.h"

#include "libscene/base/error.h"
#include "libscene/file/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

namespace masu {
namespace {

// Between two looks at whether it is cancelled.
constexpr std::chrono::milliseconds between_looks(50), longest_without_writer(5000);

} // namespace

InputStream::InputStream(const std::string& path)
    : name_(path == "-" ? "stdin" : path), is_ours_(path != "-"),
      file_(path == "-" ? STDIN_FILENO : open_to_read(path)) {
  if (file_ < 0) fail(std::string("can't be opened: ") + std::strerror(errno));
  if (fstat(file_, &opened_) != 0) opened_.st_mode = 0; // reading tells why
}

InputStream::~InputStream() {
  if (is_ours_) close(file_);
}

void InputStream::fail(const std::string& what) const {
  throw Error(ErrorCode::input, name_, what);
}

std::size_t InputStream::read(void* to, std::size_t bytes) {
  std::size_t all = 0;
  while (all < bytes) {
    const std::size_t got = read_some(static_cast<char*>(to) + all, bytes - all);
    if (got == 0) break;
    all += got;
  }
  return all;
}

std::size_t InputStream::read_some(void* to, std::size_t bytes) {
  while (!cancelled_) {
    if (!is_ours_ && !is_readable()) continue; // it may block
    const ssize_t got = ::read(file_, to, bytes);
    if (got > 0) return begun_ = true, static_cast<std::size_t>(got);
    if (got == 0) {
      // (On standard input a pipe without a writer is at its end.)
      if (begun_ || !is_ours_ || !S_ISFIFO(opened_.st_mode)) return 0;
      wait_for_writer();
    } else if (errno == EAGAIN) {
      begun_ = true; // there is a writer
      static_cast<void>(is_readable());
    } else if (errno != EINTR) {
      fail(errno == EISDIR ? std::string("is a directory: name a file")
                           : std::string("can't be read: ") + std::strerror(errno));
    }
  }
  return 0;
}

// Waits a moment for bytes, for the end, or for an error.
bool InputStream::is_readable() const {
  pollfd readable{file_, POLLIN, 0};
  return poll(&readable, 1, static_cast<int>(between_looks.count())) != 0;
}

void InputStream::wait_for_writer() {
  if ((waited_ += between_looks) > longest_without_writer)
    fail("is a pipe that nobody writes to: start its writer first");
  std::this_thread::sleep_for(between_looks);
}

} // namespace masu
