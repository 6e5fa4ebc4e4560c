// What of a machine's GPUs a program lets CUDA see that uses one.
#include "tools/common/cli.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace masu {
namespace {

TEST(FirstGpu, IsSeenAloneUnlessTheEnvironmentSaysWhatIs) {
  constexpr const char* variable = "CUDA_VISIBLE_DEVICES";
  unsetenv(variable);
  see_first_gpu_alone();
  EXPECT_STREQ(std::getenv(variable), "0");
  for (const char* const given : {"2", "1,0", ""}) {
    setenv(variable, given, 1);
    see_first_gpu_alone();
    EXPECT_STREQ(std::getenv(variable), given);
  }
  unsetenv(variable);
}

} // namespace
} // namespace masu
