// A number for the test that preloaded a library, in the file that an environment variable names.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace masu {

inline void write_count(const char* variable, std::uint64_t count) {
  const char* const path = std::getenv(variable);
  if (path == nullptr) return;
  std::array<char, 32> text{};
  const int size = std::snprintf(text.data(), text.size(), "%llu\n", static_cast<unsigned long long>(count));
  const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  static_cast<void>(!write(file, text.data(), static_cast<std::size_t>(size)));
  close(file);
}

} // namespace masu
