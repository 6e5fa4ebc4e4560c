#include "libscene/file/input_file.h"

#include "libscene/base/available_memory.h"
#include "libscene/base/error.h"
#include "libscene/file/input_stream.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

namespace masu {
namespace {

std::string gigabytes(double bytes) {
  return fmt::format("{:.2g} GB", bytes * 1e-9);
}

} // namespace

bool has_changed(int file, const struct stat& opened) {
  struct stat now {};
  return fstat(file, &now) != 0 || now.st_size != opened.st_size ||
         now.st_mtim.tv_sec != opened.st_mtim.tv_sec || now.st_mtim.tv_nsec != opened.st_mtim.tv_nsec;
}

int open_to_read(const std::string& path) {
  return open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
}

// --- Regular files -----------------------------------------------------------------------------------------

InputFile::InputFile(std::string path) : path_(std::move(path)), file_(open_to_read(path_)) {
  if (file_ < 0) fail(std::string("can't be opened: ") + std::strerror(errno));
  std::string why;
  if (fstat(file_, &opened_) != 0)
    why = std::string("can't be read: ") + std::strerror(errno);
  else if (S_ISDIR(opened_.st_mode))
    why = "is a directory: name a file";
  else if (!S_ISREG(opened_.st_mode))
    why = "isn't a regular file: name a file";
  if (why.empty()) return;
  close(std::exchange(file_, -1));
  fail(why);
}

InputFile::~InputFile() {
  if (file_ >= 0) close(file_);
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), opened_(other.opened_) {}

void InputFile::fail(const std::string& what) const {
  throw Error(ErrorCode::input, path_, what);
}

HostBytes InputFile::memory(std::uint64_t bytes) const {
  const auto needed = static_cast<double>(bytes);
  if (const double available = available_memory_for(needed); needed > available)
    fail(fmt::format("needs {} of memory, {} are available: use a machine with more memory",
                     gigabytes(needed), gigabytes(available)));
  return HostBytes(bytes);
}

void InputFile::read(std::uint64_t offset, std::span<std::uint8_t> to) const {
  while (!to.empty()) {
    const ssize_t got = pread(file_, to.data(), to.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(std::string("can't be read: ") + std::strerror(errno));
    if (got == 0) fail("was truncated while it was read: run again when it is complete");
    offset += static_cast<std::uint64_t>(got);
    to = to.subspan(static_cast<std::size_t>(got));
  }
}

void InputFile::check_unchanged() const {
  if (has_changed(file_, opened_)) fail("was changed while it was in use: run again when it is complete");
}

HostBytes InputFile::contents() const {
  HostBytes bytes = memory(size());
  read(0, bytes);
  check_unchanged();
  return bytes;
}

// --- Texts -------------------------------------------------------------------------------------------------

TextSource TextSource::of(std::string_view text) {
  const auto read = [text](char* to, std::size_t wanted) mutable {
    const std::string_view part = text.substr(0, wanted);
    std::copy(part.begin(), part.end(), to);
    text.remove_prefix(part.size());
    return part.size();
  };
  return {read, text.size()};
}

TextSource TextSource::of(const InputFile& file) {
  const auto read = [&file, offset = std::uint64_t{0}](char* to, std::size_t wanted) mutable {
    const std::uint64_t part = std::min<std::uint64_t>(wanted, file.size() - offset);
    file.read(offset, {reinterpret_cast<std::uint8_t*>(to), part});
    offset += part;
    return static_cast<std::size_t>(part);
  };
  return {read, file.size()};
}

TextSource text_stream(const std::string& path) {
  const auto read = [stream = std::make_shared<InputStream>(path),
                     before = std::uint64_t{0}](char* to, std::size_t bytes) mutable {
    std::size_t all = 0;
    while (all < bytes) {
      const std::size_t got = stream->read_some(to + all, bytes - all);
      if (got == 0) break;
      if (const void* const zero = std::memchr(to + all, 0, got))
        stream->fail(fmt::format("isn't a text: its byte {} is zero",
                                 before + static_cast<std::uint64_t>(static_cast<const char*>(zero) - to)));
      all += got;
    }
    before += all;
    return all;
  };
  return {read, {}};
}

std::string read_to_end(const std::function<std::size_t(char*, std::size_t)>& read, const std::string& name) {
  constexpr std::size_t chunk = std::size_t{1} << 20;
  // What is made of it takes as much again, or more.
  const double limit = available_memory() / 2;
  std::string text;
  for (;;) {
    const std::size_t before = text.size();
    if (static_cast<double>(before) + static_cast<double>(chunk) > limit)
      throw Error(ErrorCode::input, name,
                  fmt::format("is longer than {}, half of the available memory: give less, or a machine more",
                              gigabytes(limit)));
    if (text.capacity() - before < chunk) text.reserve(2 * before + chunk);
    text.resize(before + chunk);
    const std::size_t got = read(text.data() + before, chunk);
    text.resize(before + got);
    if (got < chunk) return text;
  }
}

std::string read_text_input(const std::string& path) {
  return read_to_end(text_stream(path).read, path == "-" ? "stdin" : path);
}

} // namespace masu
