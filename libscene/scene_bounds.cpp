// Once for all boxes, for TBB takes long to compile.
#include "libscene/scene_bounds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace masu {

Boxd join_of_ranges(std::size_t count, const std::function<Boxd(std::size_t, std::size_t)>& box_of) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, count), empty_box<double>(),
      [&](const tbb::blocked_range<std::size_t>& range, const Boxd& box) {
        return join(box, box_of(range.begin(), range.end()));
      },
      [](const Boxd& a, const Boxd& b) { return join(a, b); });
}

} // namespace masu
