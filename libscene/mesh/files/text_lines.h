// Lines of a text, and the words and numbers in a line.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace masu {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// In any case of letters.
inline bool is_word(std::string_view word, std::string_view lower_case) {
  return std::ranges::equal(word, lower_case, {}, [](char c) { return c >= 'A' && c <= 'Z' ? c | ' ' : c; });
}

// A text's beginning, for errors.
std::string excerpt(std::string_view text, std::size_t longest = 24);

// Lines end with LF, CR or both. Words are separated by blanks.
class TextLines {
public:
  // `text` and `name` outlive it. `comment` begins a comment up to the line's end, if it isn't 0. A byte
  // order mark is passed over.
  TextLines(std::string_view text, const std::string& name, char comment,
            const std::function<void(double)>& progress = {});

  // A backslash at a line's end joins the next one to it, but for comments'.
  void join_lines() { joins_ = true; }
  // Errors repeat no word of the text.
  void quote_nothing() { quotes_ = false; }

  // Goes to the next line that has a word. False at the text's end.
  bool next();
  // The same; at the end an error that says what is expected.
  void need_line(const char* what) {
    if (!next()) fail_at_end(what);
  }
  // The next word of the line, empty at its end; peek() doesn't pass it.
  std::string_view word();
  std::string_view peek();
  // All that is left of the line, comments too, without blanks round it.
  std::string_view rest();
  bool is_at_end(); // of the line

  // The next word as a number; `what` is what it is, for errors. Numbers can be infinite or NaN by that name.
  double number(const char* what);
  std::int64_t whole(const char* what);

  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - next_); } // after this line
  const char* position() const { return position_; }
  void go_to(const char* position) { position_ = position; } // in the line
  std::uint64_t line() const { return line_; }
  // Throws Error(input, name:line, message).
  [[noreturn]] void fail(const std::string& message) const;
  // That the text ends, or the next word stands, where `what` is expected.
  [[noreturn]] void fail_at_end(const std::string& what) const;
  [[noreturn]] void fail_at_word(const char* what);

private:
  bool is_end_of_word(const char* p) const { return p == line_end_ || is_blank(*p) || *p == comment_; }
  void skip_blanks() {
    while (position_ != line_end_ && is_blank(*position_))
      ++position_;
  }
  void take_line();
  void join();

  const std::string* name_;
  const std::function<void(double)>* progress_;
  const char *begin_, *end_, *next_; // of the text, and of the next line
  const char *position_, *line_end_; // in this one
  const char *newline_, *reported_;  // the next LF from next_ on; where progress was last said
  std::string joined_;
  std::uint64_t line_ = 0;
  char comment_;
  bool joins_ = false, quotes_ = true;
};

} // namespace masu
