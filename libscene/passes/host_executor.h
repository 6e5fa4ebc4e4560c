// Executors (executor.h) on the host: on all of its cores, or on one of them.
#pragma once

#include "libscene/base/host_array.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/passes/executor.h"
#include "libscene/passes/thread_group.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>
#include <vector>

namespace masu {

// `parallel`: by all cores; else plain loops, for the parts of a grid that one thread builds (merge.cpp).
template <bool parallel>
class HostExecutor {
public:
  ProgressMonitor* progress = nullptr; // of the build that the passes are of; may be null

  static constexpr bool has_warps = false;
  using Memory = HostMemory;
  template <class T>
  using Array = HostArray<T>;

  template <class T>
  Array<T> array(std::uint64_t count) const {
    return Array<T>(count);
  }
  template <class T>
  Array<T> zeros(std::uint64_t count) const {
    return Array<T>(count, T{});
  }
  template <class Act>
  void for_each(std::uint64_t count, const Act& act) const {
    for_each_range(count, 512, act);
  }
  template <class Work>
  void for_each_by_group(std::uint64_t count, const Work& work) const {
    for_each_range(count, 32, [&](std::uint64_t i) {
      typename Work::Scratch scratch; // NOLINT(cppcoreguidelines-pro-type-member-init): work writes it first
      work(SingleThread{}, scratch, i);
    });
  }
  template <class T>
  void scan(Array<T>& values) const {
    if constexpr (!parallel) {
      T sum{};
      for (T& value : values)
        value = std::exchange(sum, sum + value);
      return;
    }
    constexpr std::uint64_t chunk = 1 << 16;
    const std::uint64_t chunks = (values.size() + chunk - 1) / chunk;
    std::vector<T> sums(chunks, T{});
    const auto over = [&](std::uint64_t c, const auto& act) {
      check_progress(progress);
      T sum = sums[c];
      const std::uint64_t end = std::min<std::uint64_t>(values.size(), (c + 1) * chunk);
      for (std::uint64_t i = c * chunk; i != end; ++i)
        act(values[i], sum);
      return sum;
    };
    if (chunks > 1) {
      tbb::parallel_for(std::uint64_t{0}, chunks, [&](std::uint64_t c) {
        sums[c] = over(c, [](const T& value, T& sum) { sum = sum + value; });
      });
      T sum{};
      for (T& own : sums)
        own = std::exchange(sum, sum + own);
    }
    tbb::parallel_for(std::uint64_t{0}, chunks, [&](std::uint64_t c) {
      over(c, [](T& value, T& sum) { value = std::exchange(sum, sum + value); });
    });
  }
  template <class T>
  T value(const Array<T>& values, std::uint64_t i) const {
    return values[i];
  }

  // Pairs go into buckets by the key's highest bits while they are emitted, so that sorting a bucket stays in
  // the cache; buckets and chunks of items don't depend on the number of threads. What a bucket leaves of a
  // key fits in 32 bits: wider keys make more buckets.
  template <class Value, class Emit>
  std::optional<Sorted<HostExecutor, Value>> emit_sorted(std::uint64_t count, int bits,
                                                         std::uint64_t max_pairs, const Emit& emit) const {
    struct Pair {
      std::uint32_t key; // within the bucket
      Value value;
    };
    // Bucket b's pairs are pairs[begin[b]] … pairs[begin[b + 1] - 1].
    struct Chunk {
      std::vector<Pair> pairs;
      std::vector<std::uint32_t> begin;
    };
    constexpr std::uint64_t items_per_chunk = 4096, all_rows = ~std::uint64_t{0};
    const int bucket_bits = std::clamp(bits - 10, 12, 32);
    const std::uint64_t buckets = (std::uint64_t{1} << std::max(bits - bucket_bits, 0)),
                        mask = (std::uint64_t{1} << bucket_bits) - 1;
    std::vector<Chunk> chunks((count + items_per_chunk - 1) / items_per_chunk);
    std::atomic<std::uint64_t> total = 0;
    tbb::parallel_for(std::uint64_t{0}, chunks.size(), [&](std::uint64_t c) {
      std::vector<std::pair<std::uint64_t, Value>> emitted;
      const std::uint64_t end = std::min(count, (c + 1) * items_per_chunk);
      for (std::uint64_t i = c * items_per_chunk; i != end && emitted.size() <= max_pairs; ++i) {
        if (i % 16 == 0) check_progress(progress);
        emit(i, 0, all_rows,
             [&](std::uint64_t key, const Value& value) { emitted.emplace_back(key, value); });
      }
      if ((total += emitted.size()) > max_pairs) return;
      Chunk& chunk = chunks[c];
      chunk.begin.assign(buckets + 1, 0);
      for (const auto& [key, value] : emitted)
        ++chunk.begin[(key >> bucket_bits) + 1];
      for (std::uint64_t b = 0; b < buckets; ++b)
        chunk.begin[b + 1] += chunk.begin[b];
      std::vector<std::uint32_t> next(chunk.begin.begin(), chunk.begin.end() - 1);
      chunk.pairs.resize(emitted.size());
      for (const auto& [key, value] : emitted)
        chunk.pairs[next[key >> bucket_bits]++] = {static_cast<std::uint32_t>(key & mask), value};
    });
    if (total > max_pairs) return std::nullopt;

    std::vector<std::uint64_t> begin(buckets + 1, 0);
    for (const Chunk& chunk : chunks) {
      for (std::uint64_t b = 0; b < buckets; ++b)
        begin[b + 1] += chunk.begin[b + 1] - chunk.begin[b];
    }
    for (std::uint64_t b = 0; b < buckets; ++b)
      begin[b + 1] += begin[b];
    auto keys = array<std::uint64_t>(total);
    auto values = array<Value>(total);
    tbb::parallel_for(std::uint64_t{0}, buckets, [&](std::uint64_t bucket) {
      check_progress(progress);
      const std::uint64_t first = begin[bucket], pair_count = begin[bucket + 1] - first;
      if (pair_count == 0) return;
      const auto for_each_pair = [&](const auto& act) {
        for (const Chunk& chunk : chunks) {
          for (std::uint32_t i = chunk.begin[bucket]; i != chunk.begin[bucket + 1]; ++i)
            act(chunk.pairs[i]);
        }
      };
      const auto put = [&](std::uint64_t i, const Pair& pair) {
        keys[first + i] = bucket << bucket_bits | pair.key;
        values[first + i] = pair.value;
      };
      if (pair_count < (std::uint64_t{1} << bucket_bits) / 16) { // few in many: by comparison
        std::vector<Pair> sorted;
        sorted.reserve(pair_count);
        for_each_pair([&](const Pair& pair) { sorted.push_back(pair); });
        std::stable_sort(sorted.begin(), sorted.end(),
                         [](const Pair& a, const Pair& b) { return a.key < b.key; });
        for (std::uint64_t i = 0; i < pair_count; ++i)
          put(i, sorted[i]);
      } else {
        std::vector<std::uint32_t> next((std::size_t{1} << bucket_bits) + 1, 0);
        for_each_pair([&](const Pair& pair) { ++next[pair.key + 1]; });
        for (std::size_t i = 1; i < next.size(); ++i)
          next[i] += next[i - 1];
        for_each_pair([&](const Pair& pair) { put(next[pair.key]++, pair); });
      }
    });
    return Sorted<HostExecutor, Value>{std::move(keys), std::move(values)};
  }

private:
  template <class Act>
  void for_each_range(std::uint64_t count, std::uint64_t grain, const Act& act) const {
    const auto over = [&](std::uint64_t begin, std::uint64_t end) {
      while (begin != end) {
        check_progress(progress);
        for (const std::uint64_t next = std::min(end, begin + grain); begin != next; ++begin)
          act(begin);
      }
    };
    if constexpr (parallel) {
      tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, count, grain),
                        [&](const auto& range) { over(range.begin(), range.end()); });
    } else {
      over(0, count);
    }
  }
};

using TbbExecutor = HostExecutor<true>;
using SerialExecutor = HostExecutor<false>;

} // namespace masu
