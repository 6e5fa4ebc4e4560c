// Files that are read. Their bytes are copied into memory of this process before they are checked and used:
// another process that truncates or overwrites a file while it is in use changes nothing, as it would in a
// mapping, whose pages can change after the check, or end the process by SIGBUS.
#pragma once

#include "libscene/file/private_memory.h"

#include <sys/stat.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace masu {

// A regular file, read at any offset by any thread.
class InputFile {
public:
  // Throws Error(input, path, …): missing, unreadable, a directory, a pipe, a device.
  explicit InputFile(std::string path);
  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  InputFile& operator=(InputFile&&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return static_cast<std::uint64_t>(opened_.st_size); } // when it was opened

  // Memory for its bytes, which are to be read. Throws Error(input, path, …) where they need more memory than
  // is available.
  PrivateMemory memory() const;
  // Fills `to`. Throws Error(input, path, …): also where the file has become shorter.
  void read(std::uint64_t offset, std::span<std::uint8_t> to) const;
  // To be called after the last read: throws Error(input, path, …) where the file was written meanwhile, so
  // that what was read may be neither its old nor its new contents.
  void check_unchanged() const;

private:
  [[noreturn]] void fail(const std::string& what) const;

  std::string path_;
  int file_ = -1;
  struct stat opened_ {};
};

// All bytes of a regular file, read by several threads.
class FileContents {
public:
  // Throws Error(input, path, …).
  explicit FileContents(const std::string& path);
  std::span<const std::uint8_t> bytes() const { return memory_.bytes(); }
  std::string_view text() const { return {reinterpret_cast<const char*>(bytes().data()), bytes().size()}; }

private:
  PrivateMemory memory_;
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
