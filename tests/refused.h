// Whether something is refused with an Error of that code and place: an invalid file with input and its path.
#pragma once

#include "libscene/base/error.h"

#include <gtest/gtest.h>

#include <exception>
#include <string>

namespace masu {

// Calls open(path). `says` must be part of the message.
template <class Open>
testing::AssertionResult is_refused(const Open& open, const std::string& path, const std::string& says = "",
                                    ErrorCode code = ErrorCode::input) {
  try {
    open(path);
  } catch (const Error& error) {
    if (error.code() != code)
      return testing::AssertionFailure() << "refused, but by another code: " << error.what();
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

// The same of an act that takes no path.
template <class Act>
testing::AssertionResult is_refused_with(ErrorCode code, const std::string& place, const Act& act,
                                         const std::string& says = "") {
  return is_refused([&](const std::string&) { act(); }, place, says, code);
}

} // namespace masu
