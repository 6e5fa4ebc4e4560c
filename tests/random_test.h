// The base of tests with random scenes.
#pragma once

#include "stability/test_scene.h"
#include "tests/seeded_test.h"

#include <tbb/global_control.h>

namespace masu {

class RandomTest : public SeededTest {
protected:
  Chance chance_{seed_};
};

// Of tests for either store, and so for either arithmetic.
using Reals = testing::Types<float, double>;

// What make() makes by at most so many threads.
template <class Make>
auto made_by_threads(std::size_t threads, const Make& make) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return make();
}
// Calls check(what one thread makes, what more make).
template <class Make, class Check>
void compare_threads(const Make& make, const Check& check) {
  const auto first = made_by_threads(1, make);
  for (const std::size_t threads : {2U, 3U, 16U}) {
    SCOPED_TRACE(threads);
    check(first, made_by_threads(threads, make));
  }
}

} // namespace masu
