// Whether an invalid file is refused with Error(input, path).
#pragma once

#include "libscene/base/error.h"

#include <gtest/gtest.h>

#include <exception>
#include <string>

namespace masu {

// Calls open(path). `says` must be part of the message.
template <class Open>
testing::AssertionResult is_refused(const Open& open, const std::string& path, const std::string& says = "") {
  try {
    open(path);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::input)
      return testing::AssertionFailure() << "refused, but not as bad input: " << error.what();
    if (error.place() != path)
      return testing::AssertionFailure() << "the error names another place: " << error.what();
    if (error.message().empty() || error.message().find('\n') != std::string::npos)
      return testing::AssertionFailure() << "the message isn't one line: " << error.what();
    if (error.message().find(says) == std::string::npos)
      return testing::AssertionFailure() << "the message lacks '" << says << "': " << error.what();
    return testing::AssertionSuccess();
  } catch (const std::exception& error) {
    return testing::AssertionFailure() << "something else than Error was thrown: " << error.what();
  }
  return testing::AssertionFailure() << "it was taken for good";
}

} // namespace masu
