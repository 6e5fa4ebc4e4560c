// The lexer of NFF text: words and numbers separated by white space and comments; positions for errors.
#pragma once

#include "libscene/scene.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace masu::nff {

// A text, or some lines of it; and its name in errors.
struct Text {
  std::string_view characters;
  const std::string& name;
  std::uint64_t lines_before = 0, bytes_after = 0; // those of the whole text

  const char* begin() const { return characters.data(); }
  const char* end() const { return characters.data() + characters.size(); }
};

// "name:line:column". Lines end with LF, CR or both; columns count bytes from 1.
std::string place_of(const Text& text, const char* position);

// Throws Error(input, its place, message).
[[noreturn]] void fail(const Text& text, const char* position, const std::string& message);

// Blanks, and what begins a comment.
inline constexpr std::array<bool, 256> token_ends = [] {
  std::array<bool, 256> ends{};
  for (const char end : {' ', '\t', '\n', '\r', '\v', '\f', '#'})
    ends[static_cast<unsigned char>(end)] = true;
  return ends;
}();
inline bool ends_token(char c) {
  return token_ends[static_cast<unsigned char>(c)];
}
inline bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}
// Whether a number may start with c.
inline bool is_number_start(char c) {
  return is_digit(c) || c == '-' || c == '+' || c == '.';
}

inline constexpr std::array<double, 23> powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Reads token by token. `syntax` is the form of the current entity, for error messages.
class Lexer {
public:
  // `text` must outlive the lexer.
  Lexer(const Text& text, const char* from) : text_(&text), position_(from), end_(text.end()) {}

  const Text& text() const { return *text_; }
  // The next token's first character, or the text's end.
  const char* next() {
    while (position_ != end_ && ends_token(*position_))
      skip_blank();
    return position_;
  }
  bool next_is_number() { return next() != end_ && is_number_start(*position_); }
  // The next token; empty at the end.
  std::string_view word() {
    const char* start = next();
    while (position_ != end_ && !ends_token(*position_))
      ++position_;
    return {start, static_cast<std::size_t>(position_ - start)};
  }

  double number(const char* syntax);
  // A number of magnitude at most 1e100.
  double coordinate(const char* syntax);
  // A number in the range of float32.
  float factor(const char* syntax);
  // Throws Error(input, its place, the token at `position` and `message`).
  [[noreturn]] void refuse(const char* position, const std::string& message) const;
  // A whole number from `min` to `max`.
  std::uint64_t whole(std::uint64_t min, std::uint64_t max, const char* syntax);

private:
  void skip_blank();
  bool plain_number(double& value);
  double other_number(const char* syntax);

  const Text* text_;
  const char* position_;
  const char* end_;
};

inline void Lexer::skip_blank() {
  if (*position_ == '#')
    while (position_ != end_ && *position_ != '\n' && *position_ != '\r')
      ++position_;
  else
    ++position_;
}

// The fast path for nearly all numbers: up to 19 digits without exponent, whose value is an exact integer
// divided once, and so correctly rounded. False leaves the lexer's position unchanged.
inline bool Lexer::plain_number(double& value) {
  const char* p = position_;
  const bool is_negative = p != end_ && *p == '-';
  if (is_negative) ++p;
  const char* const digits = p;
  std::uint64_t mantissa = 0;
  for (; p != end_ && is_digit(*p); ++p)
    mantissa = 10 * mantissa + static_cast<std::uint64_t>(*p - '0');
  auto count = p - digits;
  std::ptrdiff_t decimals = 0;
  if (p != end_ && *p == '.') {
    const char* const fraction = ++p;
    for (; p != end_ && is_digit(*p); ++p)
      mantissa = 10 * mantissa + static_cast<std::uint64_t>(*p - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count == 0 || count > 19 || mantissa > (1ULL << 53) || (p != end_ && !ends_token(*p))) return false;
  position_ = p;
  const double magnitude = static_cast<double>(mantissa) / powers_of_ten[static_cast<std::size_t>(decimals)];
  value = is_negative ? -magnitude : magnitude;
  return true;
}

inline double Lexer::number(const char* syntax) {
  double value = 0;
  next();
  return plain_number(value) ? value : other_number(syntax);
}

inline double Lexer::coordinate(const char* syntax) {
  double value = 0;
  const char* const start = next();
  if (plain_number(value)) return value; // below 1e19
  value = other_number(syntax);
  if (std::abs(value) > max_coordinate)
    refuse(start, " is too large: scale the scene to coordinates within 1e100");
  return value;
}

} // namespace masu::nff
