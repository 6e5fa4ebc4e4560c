// The rays of the stability sweeps have the same hits on CPU and GPU, bit for bit.
#include "stability/oracle/backends.h"

#include <gtest/gtest.h>

namespace masu::stability {
namespace {

class StabilityOnGpu : public testing::TestWithParam<Sweep> {};

TEST_P(StabilityOnGpu, RobustAndDoubleHitsEqualTheCpus) {
  std::string why;
  if (!cuda_available(why)) GTEST_SKIP() << "no GPU, nothing was compared: " << why;
  const RandomSeed seed;
  SCOPED_TRACE(seed.trace());
  compare_backends(GetParam(), {static_cast<std::size_t>(cases(2000)), seed.value()},
                   [](const Difference& difference) {
                     if (difference.mode.precision == Precision::fast) return;
                     EXPECT_EQ(difference.differing, 0U)
                         << difference.mode.name << " at " << difference.step << " of " << difference.rays;
                   });
}

INSTANTIATE_TEST_SUITE_P(Sweeps, StabilityOnGpu, testing::ValuesIn(all_sweeps()), [](const auto& test) {
  std::string name = test.param.name;
  std::erase(name, '-');
  return name;
});

} // namespace
} // namespace masu::stability
