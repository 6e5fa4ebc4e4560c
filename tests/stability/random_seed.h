// Seeds of random tests, which can be repeated: MASU_TEST_SEED of the environment, or else a new one. Print
// it where a test fails by SCOPED_TRACE(seed.trace()). And how many cases they try.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace masu {

// The number of cases that a test runs: `usual`, times MASU_TEST_EFFORT of the environment, one at least.
inline std::int64_t cases(std::int64_t usual) {
  const char* effort = std::getenv("MASU_TEST_EFFORT");
  if (effort == nullptr) return usual;
  return std::max(static_cast<std::int64_t>(static_cast<double>(usual) * std::atof(effort)), std::int64_t{1});
}

class RandomSeed {
public:
  RandomSeed() {
    if (const char* given = std::getenv("MASU_TEST_SEED"))
      value_ = std::strtoull(given, nullptr, 10);
    else
      value_ = std::random_device{}();
  }

  explicit RandomSeed(std::uint64_t value) : value_(value) {}

  std::uint64_t value() const { return value_; }
  std::mt19937_64 engine() const { return std::mt19937_64(value_); }
  std::string trace() const { return "run again with MASU_TEST_SEED=" + std::to_string(value_); }

private:
  std::uint64_t value_;
};

} // namespace masu
