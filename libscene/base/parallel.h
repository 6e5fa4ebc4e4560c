// Loops, and pairs of tasks, by all threads: oneTBB's, compiled once for whatever they do, since its
// templates take long to compile.
//
// Where a task of the work that these are part of has thrown, TBB leaves out, without a word, what hasn't
// begun of the rest. Then these throw, lest somebody goes on with what wasn't made; TBB has the first
// exception already, and drops this one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

namespace masu {

// Calls act(begin, end) for ranges that 0 … count - 1 is cut into, down to half of `grain` (at least 1).
using RangeAction = std::function<void(std::uint64_t begin, std::uint64_t end)>;
void parallel_ranges(std::uint64_t count, std::uint64_t grain, const RangeAction& act);

// Calls both, `last` by this thread.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& last);

// Calls act(i) for i = 0 … count - 1.
template <class Act>
void parallel_for(std::uint64_t count, const Act& act) {
  parallel_ranges(count, 1, [&act](std::uint64_t i, std::uint64_t end) {
    for (; i != end; ++i)
      act(i);
  });
}

// The join(…, …), in their order, of `first` and of(begin, end) of all ranges: the same for any number of
// threads where join() is associative.
template <class Part, class Of, class Join>
Part parallel_reduce(std::uint64_t count, std::uint64_t grain, Part first, const Of& of, const Join& join) {
  if (count <= grain) return count == 0 ? first : join(first, of(0, count)); // as for one ray: without a list
  std::mutex mutex;
  std::vector<std::pair<std::uint64_t, Part>> parts; // and where each begins
  const auto add = [&](std::uint64_t begin, std::uint64_t end) {
    Part part = of(begin, end);
    const std::lock_guard lock(mutex);
    parts.emplace_back(begin, std::move(part));
  };
  parallel_ranges(count, grain, std::cref(add));
  std::ranges::sort(parts, {}, [](const auto& part) { return part.first; });
  for (const auto& [begin, part] : parts)
    first = join(first, part);
  return first;
}

} // namespace masu
