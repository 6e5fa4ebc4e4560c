// Passes that others are made of, on whatever executor (executor.h).
#pragma once

#include "libscene/base/atomic.h"
#include "libscene/passes/executor.h"

namespace masu {

// sums[i] is what of(0) … of(i - 1) add up to; for i up to `count`.
template <class Executor, class Of>
ArrayOf<Executor, std::uint32_t> sums_before(Executor& executor, std::uint64_t count, const Of& of) {
  return executor.template sums<std::uint32_t>(
      count + 1, [=] MASU_PASS(std::uint64_t i) { return i != count ? std::uint32_t{of(i)} : 0U; });
}

template <class Part>
struct ElementOf {
  const Part* elements;
  MASU_HD Part operator()(std::uint64_t i) const { return elements[i]; }
};

// As joined_in_order().
template <class Part, class Executor, class Of>
Part joined_by_shares(Executor& executor, std::uint64_t count, const Of& of) {
  constexpr std::uint64_t share = 64, ahead = 8;
  const std::uint64_t parts_count = (count + share - 1) / share;
  auto parts = executor.template array<Part>(parts_count);
  Part* const part = parts.data();
  executor.for_each_part(parts_count, [=] MASU_PASS(std::uint64_t begin, std::uint64_t end) {
    if (end - begin == 1) { // a thread's on a device: in registers, with some on their way
      Part own{};
      for (std::uint64_t i = begin; i < count; i += ahead * parts_count) {
        Part next[ahead];
        for (std::uint64_t k = 0; k < ahead; ++k)
          next[k] = i + k * parts_count < count ? of(i + k * parts_count) : Part{};
        for (const Part& its : next)
          own = join(own, its);
      }
      part[begin] = own;
      return;
    }
    // Along memory.
    for (std::uint64_t first = begin; first != end; ++first)
      part[first] = join(Part{}, of(first));
    for (std::uint64_t row = parts_count; row < count; row += parts_count)
      for (std::uint64_t first = begin; first != end && row + first < count; ++first)
        part[first] = join(part[first], of(row + first));
  });
  if (parts_count == 0) return {};
  if (parts_count == 1) return executor.value(parts, 0);
  return joined_by_shares<Part>(executor, parts_count, ElementOf<Part>{part});
}

// The join of of(0) … of(count - 1), the same on all executors where it rounds: a thread's share is so many.
template <class Part, class Executor, class Of>
Part joined_in_order(Executor& executor, std::uint64_t count, const Of& of) {
  if constexpr (!Executor::has_warps) return joined_by_shares<Part>(executor, count, of);
  // By as many threads as there are, whatever of() branches to: a thread that joins waits for memory alone.
  auto parts = executor.template array<Part>(count);
  executor.for_each(count, [=, part = parts.data()] MASU_PASS(std::uint64_t i) { part[i] = of(i); });
  return joined_by_shares<Part>(executor, count, ElementOf<Part>{parts.data()});
}

// The set (atomic.h) of so many numbers, all below `end`.
template <class Executor>
ArrayOf<Executor, std::uint32_t> set_of(Executor& executor, const std::uint32_t* numbers, std::uint64_t count,
                                        std::uint64_t end) {
  auto set = executor.template zeros<std::uint32_t>(set_words(end));
  executor.for_each(end > 0 ? count : 0, [=, words = set.data()] MASU_PASS(std::uint64_t i) {
    static_cast<void>(inserted(words, numbers[i]));
  });
  return set;
}

} // namespace masu
