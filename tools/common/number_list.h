// Names and numbers with separators between them, as options and lists of views have them.
#pragma once

#include "libscene/base/error.h"
#include "libscene/geometry/vector.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

// What stands before, between and after commas; of an empty text one empty string.
inline std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  std::size_t begin = 0, comma = 0;
  for (; (comma = text.find(',', begin)) != std::string::npos; begin = comma + 1)
    words.push_back(text.substr(begin, comma - begin));
  words.push_back(text.substr(begin));
  return words;
}

// False where the text isn't exactly so many.
template <class Number, std::size_t count>
bool read_numbers(std::string_view text, char separator, std::array<Number, count>& numbers) {
  const char* next = text.data();
  const char* const end = next + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (next == end || *next++ != separator)) return false;
    const auto [stop, error] = std::from_chars(next, end, numbers[i]);
    if (error != std::errc()) return false;
    next = stop;
  }
  return next == end;
}

// Nothing where the text isn't exactly one.
template <class Number>
std::optional<Number> read_number(std::string_view text) {
  std::array<Number, 1> number{};
  return read_numbers(text, ',', number) ? std::optional(number[0]) : std::nullopt;
}

// With commas. Throws Error(usage, option, …) for what isn't of the form, such as "X,Y".
template <class Number, std::size_t count>
std::array<Number, count> parse_numbers(const char* option, const std::string& text, const char* form) {
  std::array<Number, count> numbers{};
  if (!read_numbers(text, ',', numbers))
    throw Error(ErrorCode::usage, option, fmt::format("'{}' isn't {}", text, form));
  return numbers;
}

inline Vec3d parse_vector(const char* option, const std::string& text) {
  const auto v = parse_numbers<double, 3>(option, text, "X,Y,Z");
  return {v[0], v[1], v[2]};
}

} // namespace masu
