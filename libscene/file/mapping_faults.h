// What becomes of a program whose mapped files (file_mapping.h) change.
#pragma once

#include <thread>

namespace masu {

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
