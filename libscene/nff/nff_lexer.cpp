#include "libscene/nff/nff_lexer.h"

#include "libscene/base/error.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace masu::nff {
namespace {

// The token at `position`, quoted for a message: truncated.
std::string quoted(const Text& text, const char* position) {
  constexpr std::size_t max_size = 24;
  const std::string_view token = Lexer(text, position).word();
  return fmt::format("'{}{}'", token.substr(0, max_size), token.size() > max_size ? "..." : "");
}

} // namespace

std::string place_of(const Text& text, const char* position) {
  const std::string_view before(text.begin(), static_cast<std::size_t>(position - text.begin()));
  std::uint64_t line = text.lines_before + 1;
  std::size_t line_start = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool is_cr_of_crlf =
        before[i] == '\r' && before.data() + i + 1 != text.end() && before.data()[i + 1] == '\n';
    if (before[i] == '\n' || (before[i] == '\r' && !is_cr_of_crlf)) {
      ++line;
      line_start = i + 1;
    }
  }
  return fmt::format("{}:{}:{}", text.name, line, before.size() - line_start + 1);
}

void fail(const Text& text, const char* position, const std::string& message) {
  throw Error(ErrorCode::input, place_of(text, position), message);
}

void Lexer::refuse(const char* position, const std::string& message) const {
  fail(*text_, position, quoted(*text_, position) + message);
}

// The slow path of plain_number: exponents, a leading plus, many digits; and errors.
double Lexer::other_number(const char* syntax) {
  const char* const start = position_;
  const std::string_view token = word();
  if (token.empty())
    fail(*text_, start, fmt::format("the text ends where a number is missing: write `{}`", syntax));
  const bool has_plus = token.front() == '+';
  const bool has_sign = has_plus || token.front() == '-';
  const char* const digits = start + (has_sign ? 1 : 0);
  double value = 0;
  std::from_chars_result read{start, std::errc::invalid_argument};
  if (digits != position_ && (is_digit(*digits) || *digits == '.'))
    read = std::from_chars(has_plus ? digits : start, position_, value);
  if (read.ec == std::errc::invalid_argument || read.ptr != position_)
    refuse(start, fmt::format(" where a number is expected: write `{}`", syntax));
  const bool has_nonzero_digit =
      token.substr(0, token.find_first_of("eE")).find_first_of("123456789") != std::string_view::npos;
  if (read.ec != std::errc{} || !std::isfinite(value) || (value == 0 && has_nonzero_digit))
    refuse(start, " is out of a double's range: write a number from 1e-307 to 1e307");
  return value;
}

float Lexer::factor(const char* syntax) {
  const char* const start = next();
  const double value = number(syntax);
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max()))
    refuse(start, " is too large: colours and coefficients must be within 3.4e38");
  return static_cast<float>(value) + 0.0F; // never -0
}

std::uint64_t Lexer::whole(std::uint64_t min, std::uint64_t max, const char* syntax) {
  const char* const start = next();
  const double value = number(syntax);
  if (!(value >= static_cast<double>(min) && value <= static_cast<double>(max)) || value != std::floor(value))
    refuse(start, fmt::format(" is no whole number from {} to {}: write `{}`", min, max, syntax));
  return static_cast<std::uint64_t>(value);
}

} // namespace masu::nff
