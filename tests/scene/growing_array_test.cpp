#include "libscene/base/growing_array.h"

#include "tests/random_test.h"

namespace masu {
namespace {

using GrowingArrays = RandomTest;

TEST_F(GrowingArrays, HoldsWhatAVectorHolds) {
  auto random = seed_.engine();
  GrowingArray<int> array;
  std::vector<int> expected;
  for (int step = 0; step < 3000; ++step) {
    const auto count = static_cast<std::size_t>(random() % 50);
    switch (random() % 6) {
    case 0: {
      const std::vector<int> more(count, step);
      if (random() % 2 == 0)
        array.append(more);
      else
        std::ranges::copy(more, array.extend(count).begin());
      expected.insert(expected.end(), more.begin(), more.end());
      break;
    }
    case 1:
      array.reserve(expected.size() + count);
      break;
    case 2:
      if (random() % 20 == 0) {
        array.assign(count, step);
        expected.assign(count, step);
      }
      break;
    case 3: {
      const GrowingArray<int> copy = array;
      array = {};
      EXPECT_TRUE(array.empty());
      array = copy;
      break;
    }
    case 4:
      if (!expected.empty()) { // one of its own
        array.push_back(array[0]);
        expected.push_back(expected.front());
      }
      break;
    default:
      array.push_back(step);
      expected.push_back(step);
    }
    ASSERT_TRUE(std::equal(array.begin(), array.end(), expected.begin(), expected.end()));
  }
}

} // namespace
} // namespace masu
