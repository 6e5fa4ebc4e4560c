// Repeated queries, for the median of their times.
#pragma once

#include <algorithm>
#include <vector>

namespace masu {

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The last result of trace(), called warm_up + repeat times; its seconds.trace is the median of the last
// `repeat`, which is at least 1.
template <class Trace>
auto repeated(int warm_up, int repeat, const Trace& trace) {
  for (int i = 0; i < warm_up; ++i)
    static_cast<void>(trace());
  auto result = trace();
  std::vector<double> seconds{result.seconds.trace};
  while (seconds.size() < static_cast<std::size_t>(repeat)) {
    result = trace();
    seconds.push_back(result.seconds.trace);
  }
  result.seconds.trace = median(std::move(seconds));
  return result;
}

} // namespace masu
