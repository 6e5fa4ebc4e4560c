// What of a machine's GPUs a program lets CUDA see that uses one.
#include "tools/common/cli.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace masu {
namespace {

TEST(FirstGpu, IsSeenAloneUnlessTheEnvironmentSaysWhatIs) {
  constexpr const char* variable = "CUDA_VISIBLE_DEVICES";
  const char* const found = std::getenv(variable);
  const std::optional<std::string> before =
      found != nullptr ? std::optional<std::string>(found) : std::nullopt;
  unsetenv(variable);
  see_first_gpu_alone();
  EXPECT_STREQ(std::getenv(variable), "0");
  for (const char* const given : {"2", "1,0", ""}) {
    setenv(variable, given, 1);
    see_first_gpu_alone();
    EXPECT_STREQ(std::getenv(variable), given);
  }
  unsetenv(variable);
  if (before) setenv(variable, before->c_str(), 1); // for other tests of the same process
}

} // namespace
} // namespace masu
