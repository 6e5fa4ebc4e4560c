// The nodes of one depth of a hierarchy of high quality while it is built (spatial_split_passes.h), and how
// passes go over their fragments.
#pragma once

#include "libgrid/hierarchy/binary/combine_passes.h"
#include "libscene/passes/executor.h"

#include <algorithm>
#include <cstdint>

namespace masu {

// A node's fragments, so many side by side in their order, unless there is one alone. `room`: how many more
// they may become.
struct FragmentRange {
  std::uint32_t first, count, room;
};

// Ranges of more fragments are gone through in chunks, by a group of threads each.
inline constexpr std::uint32_t most_in_chunk = 4096;

// Of the ranges before one: their fragments but for those that are alone, their children, and the chunks of
// those that have several.
struct RangeSums {
  std::uint32_t fragments = 0, children = 0, chunks = 0;

  RangeSums() = default;
  MASU_HD explicit RangeSums(std::uint32_t count) {
    if (count < 2) return;
    fragments = count;
    children = 2;
    chunks = count > most_in_chunk ? (count + most_in_chunk - 1) / most_in_chunk : 0;
  }
  MASU_HD friend RangeSums operator+(RangeSums a, const RangeSums& b) {
    a.fragments += b.fragments;
    a.children += b.children;
    a.chunks += b.chunks;
    return a;
  }
};

// A level's nodes as combine() asks for them (combine_passes.h).
struct DividedNodes {
  const FragmentRange* ranges;
  const BinaryNode* nodes;
  const RangeSums* before;

  MASU_HD void combine(std::uint64_t i, const CombinedNodes& to) const {
    if (ranges[i].count == 1) return to.put(i, to.first + i, nodes[i], collapse_costs_of_leaf(nodes[i]));
    const Boxf box = nodes[i].box(); // around fragments before they were divided
    const std::uint32_t child = before[i].children;
    to.put_parent(i, to.first + i, box, child, static_cast<std::uint32_t>(to.first_below + child));
  }
};

// Nodes of one depth. The children of the first are the first two of the next level, and so on.
template <class Executor>
struct FragmentLevel {
  ArrayOf<Executor, FragmentRange> ranges{};
  ArrayOf<Executor, BinaryNode> nodes{}; // a fragment that is alone; of others the box
  ArrayOf<Executor, RangeSums> before{}; // each range, and all

  DividedNodes split_nodes() const { return {ranges.data(), nodes.data(), before.data()}; }
};

// Fragments sorted by their ranges in a level, but for those that are alone. Each is a leaf of the hierarchy
// that may be divided.
template <class Executor>
struct FragmentOrder {
  ArrayOf<Executor, BinaryNode> fragments{};
  ArrayOf<Executor, std::uint32_t> ranges{};
};

// The range that a chunk is of.
MASU_HD inline std::uint64_t owner_of_chunk(const RangeSums* before, std::uint64_t range_count,
                                            std::uint64_t chunk) {
  return last_not_above(range_count, chunk, [=](std::uint64_t range) { return before[range].chunks; });
}

// Passes over ranges. `Work` sums up a range's fragments, and acts on the sum:
//
//   concerns(range)                        whether there is anything to do
//   sum_up(group, sum, range, first, end)  sets the sum to that of these fragments
//   finish(group, sum, range)
//   Sum: put(group, to), join(group, of chunks, how many)
template <class Work>
struct SumRanges {
  static constexpr unsigned threads = Work::threads;
  using Scratch = typename Work::Sum;
  Work work;
  const FragmentRange* ranges;
  const RangeSums* before;
  std::uint64_t range_count;
  Scratch* chunk_sums;

  // First ranges of one chunk, then the chunks of others.
  MASU_HD std::uint64_t size(std::uint64_t i) const {
    if (i >= range_count) return work.concerns(owner(i)) ? std::uint64_t{most_in_chunk} : 0;
    return ranges[i].count <= most_in_chunk && work.concerns(i) ? ranges[i].count : 0;
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& sum, std::uint64_t i) const {
    if (size(i) == 0) return;
    const std::uint64_t own = owner(i), chunk = i - range_count;
    const bool is_whole = i < range_count;
    const auto [first, count, room] = ranges[own];
    const std::uint32_t begin =
        is_whole ? 0 : static_cast<std::uint32_t>(chunk - before[own].chunks) * most_in_chunk;
    work.sum_up(group, sum, own, first + begin, first + std::min(count, begin + most_in_chunk));
    group.sync();
    if (is_whole)
      work.finish(group, sum, own);
    else
      sum.put(group, chunk_sums[chunk]);
  }

private:
  MASU_HD std::uint64_t owner(std::uint64_t i) const {
    return i < range_count ? i : owner_of_chunk(before, range_count, i - range_count);
  }
};

// Then over those of several chunks.
template <class Work>
struct JoinChunks {
  using Scratch = typename Work::Sum;
  Work work;
  const RangeSums* before;
  std::uint64_t range_count;
  const Scratch* chunk_sums;

  // Of a range's first chunk.
  MASU_HD std::uint64_t size(std::uint64_t chunk) const {
    const std::uint64_t own = owner_of_chunk(before, range_count, chunk);
    return before[own].chunks == chunk && work.concerns(own) ? std::uint64_t{most_in_chunk} : 0;
  }
  template <class ThreadGroup>
  MASU_HD void operator()(const ThreadGroup& group, Scratch& sum, std::uint64_t chunk) const {
    if (size(chunk) == 0) return;
    const std::uint64_t own = owner_of_chunk(before, range_count, chunk);
    sum.join(group, chunk_sums + chunk, before[own + 1].chunks - before[own].chunks);
    group.sync();
    work.finish(group, sum, own);
  }
};

// `chunks`: those of all ranges that have several.
template <class Executor, class Work>
void over_ranges(Executor& executor, const FragmentLevel<Executor>& level, std::uint64_t chunks,
                 const Work& work) {
  auto sums = executor.template array<typename Work::Sum>(chunks);
  const std::uint64_t range_count = level.ranges.size();
  const RangeSums* const before = level.before.data();
  executor.for_each_by_group(range_count + chunks,
                             SumRanges<Work>{work, level.ranges.data(), before, range_count, sums.data()});
  executor.for_each_by_group(chunks, JoinChunks<Work>{work, before, range_count, sums.data()});
}

// Sums over a level's ranges, and those of all.
template <class Executor>
RangeSums sum_ranges(Executor& executor, FragmentLevel<Executor>& level) {
  const std::uint64_t count = level.ranges.size();
  level.before = executor.template sums<RangeSums>(
      count + 1, [=, range = level.ranges.data()] MASU_PASS(std::uint64_t i) {
        return i != count ? RangeSums(range[i].count) : RangeSums();
      });
  return executor.value(level.before, count);
}

} // namespace masu
