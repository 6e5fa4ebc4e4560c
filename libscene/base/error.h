// The exception type of all libraries. Each tool's main prints it as one line on stderr and returns its code.
#pragma once

#include <exception>
#include <string>
#include <utility>

namespace masu {

// The numbers are the tools' exit codes.
enum class ErrorCode : int {
  usage = 1,  // the command line
  input = 2,  // a file that can't be read or is invalid
  output = 3, // a file that can't be written
  device = 4, // the GPU or its driver
};

class Error final : public std::exception {
public:
  // place: where the error is (`scene.nff:12:3`, a file, an option); message: what is wrong: what to do.
  Error(ErrorCode code, std::string place, std::string message)
      : code_(code), place_(std::move(place)), message_(std::move(message)), text_(place_ + ": " + message_) {
  }

  ErrorCode code() const noexcept { return code_; }
  const std::string& place() const noexcept { return place_; }
  const std::string& message() const noexcept { return message_; }
  const std::string& text() const noexcept { return text_; } // place and message
  const char* what() const noexcept override { return text_.c_str(); }

private:
  ErrorCode code_;
  std::string place_, message_, text_;
};

// Of an argument.
[[noreturn]] inline void fail(const char* place, const std::string& what) {
  throw Error(ErrorCode::usage, place, what);
}

} // namespace masu
