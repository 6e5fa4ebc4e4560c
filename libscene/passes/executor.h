// Building by passes: each does the same to every one of many items, in any order or all at once. What runs
// them (an executor) is a template parameter: TbbExecutor on the host's cores, SerialExecutor on one of them
// (host_executor.h), CudaExecutor (cuda_executor.h) on a device. An executor has
//
//   Array<T>                      in its Memory: data(), size(); moves, doesn't copy
//   array<T>(count)               of any content;  zeros<T>(count)
//   for_each(count, act)          act(i) for i = 0 … count - 1
//   for_each_part(count, act)     act(begin, end) for parts of 0 … count - 1, each by one thread: on the host
//                                 as much as a core's cache holds, on a device one item
//   for_each_by_group(count, work)  work(group, scratch, i): a group of threads (thread_group.h) to each i, a
//                                 larger one where work.size(i) is large; they share a Work::Scratch. Work
//                                 without size() is never large; Work::threads says how many share it: 8,
//                                 more of a warp, or a block
//   joined<Part>(count, act)      join() of act(0) … act(count - 1), in any order: one, in its Memory
//   scan(values)                  values[i] becomes the sum of all before it
//   sums<T>(count, of)            what of(0) … of(i - 1) add up to, for i = 0 … count - 1
//   value(values, i)              one value, for the host
//   beside()                      an executor whose passes come after those so far, beside those to come
//   wait()                        until all passes are done
//   has_warps                     whether its threads run in step, so that work is better sorted by its kind
//   sorted(count, bits, key_of)   pairs of the keys key_of(i), of so many bits, and i = 0 … count - 1, in
//                                 their order; equal keys by i
//   emit_sorted<Value>(count, bits, max_pairs, emit)
//                                 all pairs that emit(i, first_row, end_row, add) makes by add(key, value),
//                                 for all rows 0 … emit.size(i) - 1 of i = 0 … count - 1, one without size():
//                                 sorted by key, of `bits` bits; equal keys as emitted. None for more than
//                                 max_pairs.
//
// What several threads write to at once is as libscene/base/atomic.h has it.
#pragma once

#include "libscene/base/portable.h"

#include <cstdint>

namespace masu {

// The last i with of(i) <= value, of `count` that rise from of(0) <= value.
template <class Of, class Value, class Index>
MASU_HD Index last_not_above(Index count, const Value& value, const Of& of) {
  Index low = 0, high = count;
  while (high - low > 1) {
    const Index middle = low + (high - low) / 2;
    (of(middle) <= value ? low : high) = middle;
  }
  return low;
}

// Of ranges that begin there, rising from 0: whose the position is in.
MASU_HD inline std::uint64_t owner_of(const std::uint64_t* begins, std::uint64_t count,
                                      std::uint64_t position) {
  return last_not_above(count, position, [=](std::uint64_t i) { return begins[i]; });
}

template <class Executor, class T>
using ArrayOf = typename Executor::template Array<T>;

// Pairs sorted by their keys.
template <class Executor, class Value>
struct Sorted {
  ArrayOf<Executor, std::uint64_t> keys{};
  ArrayOf<Executor, Value> values{};
};

// Work that needs nothing to share.
struct NoScratch {};

template <class Work>
concept has_size = requires(const Work& work) {
  work.size(0);
};

} // namespace masu
