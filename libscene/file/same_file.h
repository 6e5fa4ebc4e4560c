// Whether two paths lead to one file.
#pragma once

#include <sys/stat.h>

#include <string>

namespace masu {

// Considers links and different spellings, and paths that don't exist but would create one file. False for
// devices and pipes, which may be given twice, and for cycles of links, which lead to no file.
bool is_same_file(const std::string& a, const std::string& b);

inline bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

} // namespace masu
