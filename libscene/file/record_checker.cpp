// Once for all checks, for TBB takes long to compile.
#include "libscene/file/record_checker.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace masu {

bool all_ranges(std::uint64_t count, const std::function<bool(std::uint64_t, std::uint64_t)>& good) {
  constexpr std::uint64_t grain = 256;
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, count, grain), true,
      [&](const tbb::blocked_range<std::uint64_t>& range, bool so_far) {
        return so_far && good(range.begin(), range.end());
      },
      std::logical_and<>());
}

} // namespace masu
