// The base of tests with random numbers. What fails says how to repeat it.
#pragma once

#include "stability/random_seed.h"

#include <gtest/gtest.h>

namespace masu {

class SeededTest : public testing::Test {
protected:
  const RandomSeed seed_;

private:
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
};

} // namespace masu
