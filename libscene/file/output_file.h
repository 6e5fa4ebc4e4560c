// A file that appears whole or not at all.
#pragma once

#include "libscene/file/temporary_name.h"

#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>

namespace masu {

// What a file is until it is committed: without a name, or with a temporary one.
enum class UntilCommit { unnamed, named };

// Written to an unnamed file in its folder (O_TMPFILE); commit flushes that and gives it its name, so that a
// process killed before leaves nothing behind. Only where the file replaces another one it has a temporary
// name for a moment, since a link can't replace a file; and where the system has no unnamed files, from the
// start (temporary_name.h says who removes what is left of it). Without commit the destructor removes it.
//
// A symbolic link is written through, whether what it leads to exists or not. What is replaced hands its
// permissions, and where that is allowed its owner, on to the new file. What exists and isn't a regular file
// with a name (a pipe, /dev/null, /proc/self/fd/N of an unnamed file) is written directly.
class OutputFile {
public:
  // Throws Error(output, path, …): no such folder, a directory, no permission.
  explicit OutputFile(std::string path, UntilCommit until_commit = UntilCommit::unnamed);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;

  void write(std::span<const std::uint8_t> bytes);
  void write(const void* data, std::size_t bytes);
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
  int folder_ = -1;                        // -1: written directly
  std::optional<TemporaryName> temporary_; // while there is one
  std::FILE* stream_ = nullptr;
};

// Where `path` leads: symbolic links followed to their end, which needn't exist. Throws Error(output, path,
// …) where they lead in a circle.
std::string followed(const std::string& path);

} // namespace masu
