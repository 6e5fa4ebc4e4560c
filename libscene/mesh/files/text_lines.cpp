#include "libscene/mesh/files/text_lines.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <utility>

namespace masu {
namespace {

constexpr std::ptrdiff_t between_reports = 1 << 22; // bytes

// The first c, or the end.
const char* find(const char* begin, const char* end, char c) {
  const void* const found =
      begin != end ? std::memchr(begin, c, static_cast<std::size_t>(end - begin)) : nullptr;
  return found != nullptr ? static_cast<const char*>(found) : end;
}

} // namespace

std::string excerpt(std::string_view text, std::size_t longest) {
  return std::string(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

TextLines::TextLines(std::string_view text, const std::string& name, char comment,
                     const std::function<void(double)>& progress)
    : name_(&name), progress_(&progress), begin_(text.data()), end_(text.data() + text.size()), next_(begin_),
      position_(begin_), line_end_(begin_), newline_(begin_), reported_(begin_), comment_(comment) {
  if (text.starts_with("\xef\xbb\xbf")) next_ += 3;
  newline_ = find(next_, end_, '\n');
}

void TextLines::take_line() {
  if (newline_ < next_) newline_ = find(next_, end_, '\n');
  position_ = next_;
  line_end_ = find(next_, newline_, '\r');
  next_ = line_end_;
  if (next_ != end_) next_ += *next_ == '\r' && next_ + 1 == newline_ && newline_ != end_ ? 2 : 1;
  ++line_;
}

void TextLines::join() {
  joined_.clear();
  for (;;) {
    const bool goes_on = line_end_ != position_ && line_end_[-1] == '\\';
    joined_.append(position_, line_end_ - (goes_on ? 1 : 0));
    if (!goes_on || next_ == end_) break;
    joined_ += ' ';
    take_line();
  }
  position_ = joined_.data();
  line_end_ = position_ + joined_.size();
}

bool TextLines::next() {
  while (next_ != end_) {
    take_line();
    if (next_ - reported_ >= between_reports && *progress_) {
      reported_ = next_;
      (*progress_)(static_cast<double>(next_ - begin_) / static_cast<double>(end_ - begin_));
    }
    skip_blanks();
    if (is_at_end()) continue;
    if (joins_ && line_end_[-1] == '\\' && find(position_, line_end_, comment_) == line_end_) join();
    if (!is_at_end()) return true;
  }
  position_ = line_end_ = end_;
  return false;
}

bool TextLines::is_at_end() {
  skip_blanks();
  return position_ == line_end_ || *position_ == comment_;
}

std::string_view TextLines::peek() {
  skip_blanks();
  const char* end = position_;
  while (!is_end_of_word(end))
    ++end;
  return {position_, end};
}

std::string_view TextLines::word() {
  const std::string_view word = peek();
  position_ = word.data() + word.size();
  return word;
}

std::string_view TextLines::rest() {
  skip_blanks();
  const char* end = line_end_;
  while (end != position_ && is_blank(end[-1]))
    --end;
  return {std::exchange(position_, line_end_), end};
}

double TextLines::number(const char* what) {
  skip_blanks();
  const char* const start = position_;
  const bool has_plus = start != line_end_ && *start == '+' && start + 1 != line_end_ && start[1] != '-';
  double value = 0;
  const auto [end, fault] = std::from_chars(start + (has_plus ? 1 : 0), line_end_, value);
  if (fault == std::errc::result_out_of_range)
    fail(fmt::format("{} is out of a double's range: write a number from 1e-307 to 1e307", what));
  if (fault != std::errc() || !is_end_of_word(end)) fail_at_word(what);
  position_ = end;
  return value;
}

std::int64_t TextLines::whole(const char* what) {
  skip_blanks();
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(position_, line_end_, value);
  if (fault != std::errc() || !is_end_of_word(end)) fail_at_word(what);
  position_ = end;
  return value;
}

void TextLines::fail(const std::string& message) const {
  throw Error(ErrorCode::input, fmt::format("{}:{}", *name_, std::max<std::uint64_t>(line_, 1)), message);
}

void TextLines::fail_at_end(const std::string& what) const {
  fail(fmt::format("the file ends where {} is expected: it is cut, or its counts are wrong: complete it",
                   what));
}

void TextLines::fail_at_word(const char* what) {
  if (is_at_end()) fail(fmt::format("the line ends where {} is expected: complete it", what));
  const std::string found = quotes_ ? fmt::format("'{}'", excerpt(peek())) : "something else";
  fail(fmt::format("{} where {} is expected: correct it", found, what));
}

} // namespace masu
