// Files that are read. Bytes that are copied into memory of this process before they are checked and used
// don't change with the file; file_mapping.h has the other way.
#pragma once

#include "libscene/base/host_array.h"

#include <sys/stat.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace masu {

// Whether an open file isn't as it was when it had the status `opened`: written or truncated since. Calls
// only async-signal-safe functions.
bool has_changed(int file, const struct stat& opened);

// A descriptor, or -1 with errno. Not blocking: opening a pipe would wait for its writer. Reading a regular
// file is the same.
int open_to_read(const std::string& path);

// A regular file, read at any offset by any thread.
class InputFile {
public:
  // Throws Error(input, path, …): missing, unreadable, a directory, a pipe, a device.
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return static_cast<std::uint64_t>(opened_.st_size); } // when it was opened
  const struct stat& opened() const { return opened_; }
  int descriptor() const { return file_; }

  // Memory for so many of its bytes, which are to be read. Throws Error(input, path, …) where they need more
  // than is available.
  HostBytes memory(std::uint64_t bytes) const;
  // Fills `to`. Throws Error(input, path, …): also where the file has become shorter.
  void read(std::uint64_t offset, std::span<std::uint8_t> to) const;
  // All of its bytes. Throws Error(input, path, …).
  HostBytes contents() const;
  // To be called after the last look at its bytes: throws Error(input, path, …) where the file was written
  // since it was opened, so that what was seen may be neither its old nor its new contents.
  void check_unchanged() const;

private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  int file_ = -1;
  struct stat opened_ {};
};

// A text that is read from its start to its end, once.
struct TextSource {
  // Reads so many bytes; fewer at the end alone. Throws Error(input, …).
  std::function<std::size_t(char*, std::size_t)> read;
  std::optional<std::uint64_t> bytes{}; // of all of it, where that is known

  // Of what outlives it.
  static TextSource of(std::string_view text);
  static TextSource of(const InputFile& file);
};

// A text in a file of any kind; `path` - is standard input. At its first zero byte, which no text holds, it
// ends with an error. A pipe that no process has open for writing is waited for a few seconds. Throws
// Error(input, path or stdin, …).
TextSource text_stream(const std::string& path);

// All that read() reads up to its end. Endless inputs end with Error(input, name, …): where half of the
// memory that was available is used.
std::string read_to_end(const std::function<std::size_t(char*, std::size_t)>& read, const std::string& name);

// All of a text in a file of any kind; as text_stream() and read_to_end() read it.
std::string read_text_input(const std::string& path);

} // namespace masu
