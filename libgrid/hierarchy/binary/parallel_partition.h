// Many leaves gone through, or partitioned in place, by all cores.
#pragma once

#include "libgrid/hierarchy/binary/fragment_split.h"
#include "libscene/base/parallel.h"
#include "libscene/base/progress_monitor.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace masu {

// Calls act(chunk, begin, end) for chunks of 0 … count - 1, in parallel; so many are they.
inline constexpr std::uint32_t leaves_per_chunk = 1 << 13;
inline std::uint32_t chunks_of(std::uint32_t count) {
  return (count + leaves_per_chunk - 1) / leaves_per_chunk;
}
template <class Act>
void for_each_chunk(std::uint32_t count, const ProgressMonitor* progress, const Act& act) {
  if (count <= leaves_per_chunk) return act(0, 0, count);
  parallel_for(chunks_of(count), [&](std::uint64_t i) {
    check_progress(progress);
    const auto chunk = static_cast<std::uint32_t>(i);
    act(chunk, chunk * leaves_per_chunk, std::min(count, (chunk + 1) * leaves_per_chunk));
  });
}

// What chunks have found, one after the other.
template <class T>
std::vector<T> joined(std::vector<std::vector<T>> lists) {
  if (lists.size() == 1) return std::move(lists.front());
  std::vector<T> all;
  for (const std::vector<T>& list : lists)
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

// A fragment that is divided.
struct Divided {
  std::uint32_t fragment;
  Sides parts;
};
// Those of 0 … count - 1 of which divides(fragment, its parts) says so, in their order.
template <class Divides>
std::vector<Divided> divided_by(std::uint32_t count, const ProgressMonitor* progress,
                                const Divides& divides) {
  std::vector<std::vector<Divided>> lists(chunks_of(count));
  for_each_chunk(count, progress, [&](std::uint32_t chunk, std::uint32_t begin, std::uint32_t end) {
    Divided divided{};
    for (divided.fragment = begin; divided.fragment != end; ++divided.fragment)
      if (divides(divided.fragment, divided.parts)) lists[chunk].push_back(divided);
  });
  return joined(std::move(lists));
}

// Those that is_left() first, in the order that std::partition() leaves them in: the first one that belongs
// to the right changes places with the last one that belongs to the left, and so on. Returns how many are on
// the left.
template <class IsLeft>
std::uint32_t partitioned_by_all_cores(BinaryNode* fragments, std::uint32_t count, const IsLeft& is_left,
                                       const ProgressMonitor* progress) {
  std::vector<std::uint32_t> lefts(chunks_of(count));
  for_each_chunk(count, progress, [&](std::uint32_t chunk, std::uint32_t begin, std::uint32_t end) {
    lefts[chunk] = static_cast<std::uint32_t>(std::count_if(fragments + begin, fragments + end, is_left));
  });
  const std::uint32_t left = std::accumulate(lefts.begin(), lefts.end(), 0U);
  std::vector<std::vector<std::uint32_t>> rights_of(lefts.size()),
      lefts_of(lefts.size()); // in the wrong places
  for_each_chunk(count, progress, [&](std::uint32_t chunk, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i != end; ++i)
      if (is_left(fragments[i]) != (i < left)) (i < left ? rights_of : lefts_of)[chunk].push_back(i);
  });
  const std::vector<std::uint32_t> to_right = joined(std::move(rights_of)),
                                   to_left = joined(std::move(lefts_of));
  const auto moved = static_cast<std::uint32_t>(to_right.size());
  for_each_chunk(moved, progress, [&](std::uint32_t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i != end; ++i)
      std::swap(fragments[to_right[i]], fragments[to_left[moved - 1 - i]]);
  });
  return left;
}

} // namespace masu
