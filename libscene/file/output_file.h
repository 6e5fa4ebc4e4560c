// A file that appears whole or not at all.
#pragma once

#include "libscene/file/temporary_name.h"

#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace masu {

// Whether a file is unnamed or has a temporary name until it is committed.
enum class UntilCommit { unnamed, named };

// Writes go to an unnamed file in the target's folder (O_TMPFILE); commit flushes it and links it to its
// name, so that a process killed before leaves nothing behind. A temporary name is used only for a moment
// when the file replaces another one, since a link can't replace a file, and from the start on file systems
// without O_TMPFILE (temporary_name.h says how stale ones are removed). Without commit the destructor removes
// the file.
//
// Symbolic links are followed, dangling ones too. A file that replaces another one takes over its permissions
// and, where allowed, its owner. Anything that exists and isn't a regular file with a name (a pipe,
// /dev/null, /proc/self/fd/N of an unnamed file) is written directly; so is standard output, which is named
// - (is_standard_output()); what was printed before comes before it.
class OutputFile {
public:
  // Throws Error(output, path, …): no such folder, a directory, no permission.
  explicit OutputFile(std::string path, UntilCommit until_commit = UntilCommit::unnamed);
  ~OutputFile() { close_all(); }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::uint8_t> bytes) { write(bytes.data(), bytes.size()); }
  void write(const void* data, std::size_t bytes);
  // The next write replaces the first bytes.
  void rewind();
  // Whether the file has places for write_at(): a regular file that isn't written directly.
  bool has_places() const { return folder_ >= 0; }
  // Where the file is until it is committed. Throws Error(output) where it is unnamed or written directly.
  std::string temporary_path() const;
  // At an offset, whatever else is written, by any thread.
  void write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes);
  void commit();

  std::FILE* stream() { return stream_; }
  const std::string& path() const { return path_; }

private:
  [[noreturn]] void fail(const char* doing) const;
  int open_unnamed() const;
  int open_in_folder(UntilCommit until_commit);
  bool give_name();
  void close_all();

  std::string path_, name_;                // name_: in the folder, symbolic links followed
  int folder_ = -1;                        // file descriptor; -1: written directly
  std::optional<TemporaryName> temporary_; // while the file has one
  std::FILE* stream_ = nullptr;
};

// A text as a whole file. Throws Error(output, path, …).
void write_text_file(const std::string& path, std::string_view text);

// Whether a path means this process's standard output: -, or a name of descriptor 1, which is then not
// opened anew (that would begin a file at its start again).
bool is_standard_output(std::string_view path);

// `path` with symbolic links in its last component followed, the last of which may dangle. Throws
// Error(output, path, …) for a cycle of links.
std::string followed(const std::string& path);

// Whether two paths lead to one file. Considers links and different spellings, and paths that don't exist but
// would create one file. False for devices and pipes, which may be given twice, and for cycles of links,
// which lead to no file.
bool is_same_file(const std::string& a, const std::string& b);

// Writes all bytes at an offset of a file, which is a descriptor. Returns false and sets errno when it fails.
bool write_all_at(int file, std::uint64_t offset, std::span<const std::uint8_t> bytes);

} // namespace masu
