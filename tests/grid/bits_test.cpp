// Bit operations of the grid's map, compared with strings of binary digits.
#include "libgrid/bits.h"
#include "tests/random_test.h"

#include <gtest/gtest.h>

#include <string>

namespace masu {
namespace {

using Bits = RandomTest;

std::string binary(std::uint32_t word) {
  std::string all;
  for (int bit = 31; bit >= 0; --bit)
    all += (word >> bit & 1) != 0 ? '1' : '0';
  return all;
}

TEST_F(Bits, AppendedTakesTheTopBits) {
  auto engine = seed_.engine();
  for (int i = 0; i < 10'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(engine()), from = static_cast<std::uint32_t>(engine());
    const auto count = static_cast<std::int32_t>(engine() % 32);
    const auto n = static_cast<std::size_t>(count);
    ASSERT_EQ(binary(appended(bits, from, count)), binary(bits).substr(n) + binary(from).substr(0, n));
  }
}

TEST_F(Bits, MovedToTopShiftsTheLowestBits) {
  auto engine = seed_.engine();
  for (int i = 0; i < 10'000; ++i) {
    const auto from = static_cast<std::uint32_t>(engine());
    const auto count = static_cast<std::int32_t>(engine() % 32);
    const auto n = static_cast<std::size_t>(count);
    ASSERT_EQ(binary(moved_to_top(static_cast<std::int32_t>(from), count)),
              binary(from).substr(32 - n) + std::string(32 - n, '0'));
  }
}

TEST_F(Bits, HalfSelectsSixteenBits) {
  EXPECT_EQ(half(0x12345678, -1), 0x5678);
  EXPECT_EQ(half(0x12345678, 0), 0x1234);
  EXPECT_EQ(half(0xfedcba98, -1), 0xba98);
  EXPECT_EQ(half(0xfedcba98, 0), 0xfedc);
}

} // namespace
} // namespace masu
