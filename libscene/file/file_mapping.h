// A file's bytes, mapped: read-only and shared, so that all processes on a machine have one copy of them.
//
// A mapped file that another process truncates or overwrites changes under its reader's eyes: pages that are
// gone end the process by SIGBUS, and an index that was checked may lead anywhere when it is read again. So
// mapped files are for programs that take that on themselves: results of a file that has changed meanwhile
// are thrown away (InputFile::check_unchanged), and faults end the program with a line (MappingFaults).
#pragma once

#include "libscene/file/input_file.h"

#include <cstdint>
#include <span>
#include <thread>

namespace masu {

// Of a whole file, for as long as it lives.
class FileMapping {
public:
  FileMapping() = default;
  // The file must stay open. Waits for a moment where the file was written just now, so that what is written
  // from now on has a later time. Throws Error(input, path, …).
  explicit FileMapping(const InputFile& file);
  ~FileMapping();
  FileMapping(FileMapping&& other) noexcept { *this = std::move(other); }
  FileMapping& operator=(FileMapping&& other) noexcept;
  FileMapping(const FileMapping&) = delete;
  FileMapping& operator=(const FileMapping&) = delete;

  std::span<const std::uint8_t> bytes() const { return {begin_, size_}; }

private:
  const std::uint8_t* begin_ = nullptr;
  std::size_t size_ = 0;
};

// For a program's main: while it lives, a fault (SIGBUS, SIGSEGV) while a mapped file has changed or can't be
// read ends the program with the line `tool: path: …` and exit code 2, and so does a change that nobody has
// noticed for a while, for a walk through changed indices need not end. Nothing is left of files that were
// being written. Other faults end the program as by default.
class MappingFaults {
public:
  // `tool` must outlive it.
  explicit MappingFaults(const char* tool);
  ~MappingFaults();
  MappingFaults(const MappingFaults&) = delete;
  MappingFaults& operator=(const MappingFaults&) = delete;

private:
  std::jthread watch_;
};

} // namespace masu
