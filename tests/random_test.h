// The base of tests with random numbers. What fails says how to repeat it.
#pragma once

#include "tests/stability/test_scene.h"

#include <gtest/gtest.h>

namespace masu {

class RandomTest : public testing::Test {
protected:
  const RandomSeed seed_;
  Chance chance_{seed_};

private:
  const testing::ScopedTrace trace_{__FILE__, __LINE__, seed_.trace()};
};

} // namespace masu
