// Seeds of random tests, which can be repeated: MASU_TEST_SEED of the environment, or else a new one. Print
// it where a test fails by SCOPED_TRACE(seed.trace()).
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace masu {

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
