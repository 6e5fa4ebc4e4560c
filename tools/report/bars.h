// A histogram in characters.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace masu {

// A line for each i with counts[i] > 0, with a bar.
template <class Name>
void print_bars(const char* head, const char* counted, const std::vector<std::uint64_t>& counts,
                const Name& name) {
  std::uint64_t most = 1;
  for (const std::uint64_t count : counts)
    most = std::max(most, count);
  fmt::print("\n{:>15} {:>10}\n", head, counted);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const auto bar =
        static_cast<std::size_t>(50 * static_cast<double>(counts[i]) / static_cast<double>(most));
    fmt::print("{:>15} {:>10} {}\n", name(i), counts[i], std::string(bar, '#'));
  }
}

} // namespace masu
