// Divisions of real.h.
#include "libscene/geometry/real.h"
#include "tests/random_test.h"

namespace masu {
namespace {

class FastDivide : public RandomTest {};

TEST_F(FastDivide, IsRoundedLikeDivision) {
  std::int64_t others = 0;
  const std::int64_t tries = cases(1'000'000);
  for (std::int64_t i = tries; i > 0; --i) {
    const float over = static_cast<float>(chance_.uniform(-1, 1) * chance_.power_of_two(-30, 30)),
                by = static_cast<float>(chance_.uniform(-1, 1) * chance_.power_of_two(-60, 60));
    if (over == 0 || by == 0) continue;
    const float is = fast_divide(over, by), should = over / by;
    others += is != should;
    ASSERT_TRUE(is == should || std::nextafter(is, should) == should) << over << " / " << by;
  }
  EXPECT_LE(others, tries / 100'000);
}

TEST_F(FastDivide, ByZeroIsHugeOrNaN) {
  for (const float over : {0.0F, 1.0F, -1.0F, 1e-30F, 1e30F}) {
    for (const float by : {0.0F, -0.0F, std::numeric_limits<float>::denorm_min()})
      EXPECT_FALSE(std::abs(fast_divide(over, by)) <= 1e30F) << over << " / " << by;
  }
}

TEST_F(FastDivide, FiniteInverseIsNeverInfinite) {
  constexpr float largest = RealTraits<float>::largest;
  for (const float nothing : {0.0F, std::numeric_limits<float>::denorm_min()}) {
    EXPECT_EQ(std::abs(finite_inverse(nothing)), largest);
    EXPECT_EQ(std::abs(finite_inverse(-nothing)), largest);
  }
  EXPECT_EQ(std::abs(finite_inverse(0.0)), RealTraits<double>::largest);
  for (std::int64_t i = cases(1'000'000); i > 0; --i) {
    const float v = static_cast<float>(chance_.uniform(-1, 1) * chance_.power_of_two(-149, 125));
    const float is = finite_inverse(v), should = 1 / v;
    if (std::abs(v) >= std::numeric_limits<float>::min()) {
      ASSERT_TRUE(is == should || std::nextafter(is, should) == should) << v;
    } else {
      ASSERT_GE(std::abs(is), 0x1p125F) << v;
      ASSERT_LE(std::abs(is), largest) << v;
    }
  }
}

} // namespace
} // namespace masu
