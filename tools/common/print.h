// What tools print: tables on standard output, notes on standard error.
#pragma once

#include "libscene/base/error.h"
#include "libscene/geometry/vector.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

namespace masu {

// Prints a line on standard error, for which nothing fails: it is lost where it can't be written.
template <class... Values>
void print_note(fmt::format_string<Values...> format, Values&&... values) {
  static_cast<void>(std::fputs(fmt::format(format, std::forward<Values>(values)...).c_str(), stderr));
}

// 1234567 as 1,234,567.
inline std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;)
    text.insert(at -= 3, ",");
  return text;
}

// 16 x 16 x 8
inline std::string by_by(const Vec3i& n) {
  return fmt::format("{} x {} x {}", n.x, n.y, n.z);
}

// Prints rows of a table: a name, and from column `width` on what follows it.
struct Rows {
  int width;

  template <class... Values>
  void operator()(const char* name, fmt::format_string<Values...> format, Values&&... values) const {
    fmt::print("{:<{}} {}\n", name, width, fmt::format(format, std::forward<Values>(values)...));
  }
};

// Flushes standard output. Throws Error(output) where anything printed could not be written.
inline void flush_standard_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error(ErrorCode::output, "standard output", "can't be written");
}

} // namespace masu
