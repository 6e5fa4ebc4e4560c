#include "libscene/base/parallel.h"

#include "libscene/base/error.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace masu {
namespace {

template <class Run>
void run_whole(const Run& run) {
  tbb::task_group_context context;
  run(context);
  if (context.is_group_execution_cancelled()) throw Error(ErrorCode::usage, "tasks", "have been cancelled");
}

} // namespace

void parallel_ranges(std::uint64_t count, std::uint64_t grain, const RangeAction& act) {
  if (count == 0) return;
  if (count <= grain) return act(0, count); // without what TBB takes for a call of one ray
  run_whole([&](auto& context) {
    tbb::parallel_for(
        tbb::blocked_range<std::uint64_t>(0, count, grain),
        [&](const auto& range) { act(range.begin(), range.end()); }, context);
  });
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& last) {
  run_whole([&](auto& context) { tbb::parallel_invoke(first, last, context); });
}

} // namespace masu
