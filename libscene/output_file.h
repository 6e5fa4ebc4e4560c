// A file that appears whole or not at all.
#pragma once

#include <cstdint>
#include <cstdio>
#include <span>
#include <string>

namespace masu {

// Written under a temporary name in the same folder; commit flushes it and gives it its own name. Without
// commit the destructor removes it. A path that exists and isn't a regular file (a pipe, /dev/null) is
// written directly.
class OutputFile {
public:
  // Throws Error(output, path, …): no such folder, a directory, no permission.
  explicit OutputFile(std::string path);
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

  std::string path_, final_path_, written_path_;
  std::FILE* stream_ = nullptr;
};

} // namespace masu
