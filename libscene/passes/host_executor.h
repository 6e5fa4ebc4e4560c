// Executors (executor.h) on the host: on all of its cores, or on one of them.
#pragma once

#include "libscene/base/host_array.h"
#include "libscene/base/parallel.h"
#include "libscene/base/progress_monitor.h"
#include "libscene/passes/executor.h"
#include "libscene/passes/thread_group.h"

#include <algorithm>
#include <atomic>
#include <numeric>
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
  template <class Act>
  void for_each_part(std::uint64_t count, const Act& act) const {
    in_parts(count, std::clamp<std::uint64_t>(count / 64, 16, 1024), act); // of few, still some for each core
  }
  template <class Work>
  void for_each_by_group(std::uint64_t count, const Work& work) const {
    for_each_range(count, 32, [&](std::uint64_t i) {
      typename Work::Scratch scratch; // NOLINT(cppcoreguidelines-pro-type-member-init): work writes it first
      work(SingleThread{}, scratch, i);
    });
  }
  template <class Part, class Act>
  Array<Part> joined(std::uint64_t count, const Act& act) const {
    const auto of_range = [&](std::uint64_t begin, std::uint64_t end) {
      check_progress(progress);
      Part part{};
      for (; begin != end; ++begin)
        part = join(part, act(begin));
      return part;
    };
    if constexpr (!parallel) return Array<Part>(1, of_range(0, count));
    const auto join_both = [](const Part& a, const Part& b) { return join(a, b); };
    return Array<Part>(1, parallel_reduce(count, 512, Part{}, of_range, join_both));
  }
  template <class T>
  void scan(Array<T>& values) const {
    constexpr std::uint64_t chunk = 1 << 16;
    const std::uint64_t chunks = (values.size() + chunk - 1) / chunk;
    if (!parallel || chunks < 2) {
      std::exclusive_scan(values.begin(), values.end(), values.begin(), T{});
      return;
    }
    std::vector<T> sums(chunks);
    const auto over_chunks = [&](const auto& act) {
      parallel_for(chunks, [&](std::uint64_t c) {
        check_progress(progress);
        T* const begin = values.data() + c * chunk;
        act(sums[c], begin, begin + std::min(chunk, values.size() - c * chunk));
      });
    };
    over_chunks([](T& sum, const T* begin, const T* end) { sum = std::accumulate(begin, end, T{}); });
    std::exclusive_scan(sums.begin(), sums.end(), sums.begin(), T{});
    over_chunks([](const T& sum, T* begin, T* end) { std::exclusive_scan(begin, end, begin, sum); });
  }
  template <class T, class Of>
  Array<T> sums(std::uint64_t count, const Of& of) const {
    auto values = array<T>(count);
    for_each(count, [value = values.data(), &of](std::uint64_t i) { value[i] = of(i); });
    scan(values);
    return values;
  }
  template <class T>
  T value(const Array<T>& values, std::uint64_t i) const {
    return values[i];
  }
  const HostExecutor& beside() const { return *this; }
  void wait() const {}

  template <class KeyOf>
  Sorted<HostExecutor, std::uint32_t> sorted(std::uint64_t count, int bits, const KeyOf& key_of) const {
    return *emit_sorted<std::uint32_t>(count, bits, count,
                                       [&](std::uint64_t i, std::uint64_t, std::uint64_t, const auto& add) {
                                         add(key_of(i), static_cast<std::uint32_t>(i));
                                       });
  }

  // Pairs go into buckets by the key's highest bits, and a bucket is sorted in the cache; buckets and chunks
  // of items don't depend on the number of threads. What a bucket leaves of a key fits in 32 bits: wider keys
  // make more buckets.
  template <class Value, class Emit>
  std::optional<Sorted<HostExecutor, Value>> emit_sorted(std::uint64_t count, int bits,
                                                         std::uint64_t max_pairs, const Emit& emit) const {
    // Those that some items emit: as many as items where all chunks have theirs, in huge pages; then more. Of
    // bucket b the first one, and so on, goes to place[b], once all are counted.
    struct Chunk {
      std::uint64_t count = 0;
      std::vector<std::uint64_t> more_keys;
      std::vector<Value> more_values;
      std::vector<std::uint64_t> place;
    };
    auto first_keys = array<std::uint64_t>(count);
    auto first_values = array<Value>(count);
    constexpr std::uint64_t all_rows = ~std::uint64_t{0};
    const std::uint64_t items_per_chunk = count < (1 << 17) ? 1024 : 4096; // of few, still some for each core
    const int bucket_bits = std::clamp(bits - 10, 12, 32);
    const std::uint64_t buckets = std::uint64_t{1} << std::max(bits - bucket_bits, 0);
    std::vector<Chunk> chunks((count + items_per_chunk - 1) / items_per_chunk);
    const auto for_each_pair = [&](std::uint64_t c, const auto& act) {
      const Chunk& chunk = chunks[c];
      const std::uint64_t begin = c * items_per_chunk,
                          first = std::min({chunk.count, items_per_chunk, count - begin});
      for (std::uint64_t i = 0; i < first; ++i)
        act(first_keys[begin + i], first_values[begin + i]);
      for (std::uint64_t i = 0; i < chunk.count - first; ++i)
        act(chunk.more_keys[i], chunk.more_values[i]);
    };
    std::atomic<std::uint64_t> total = 0;
    parallel_for(chunks.size(), [&](std::uint64_t c) {
      Chunk& chunk = chunks[c];
      const std::uint64_t begin = c * items_per_chunk, end = std::min(count, begin + items_per_chunk);
      for (std::uint64_t i = begin; i != end && chunk.count <= max_pairs; ++i) {
        if (i % 16 == 0) check_progress(progress);
        emit(i, 0, all_rows, [&](std::uint64_t key, const Value& value) {
          if (const std::uint64_t place = begin + chunk.count++; place < end) {
            first_keys[place] = key;
            first_values[place] = value;
          } else {
            chunk.more_keys.push_back(key);
            chunk.more_values.push_back(value);
          }
        });
      }
      if ((total += chunk.count) > max_pairs) return;
      chunk.place.assign(buckets, 0);
      for_each_pair(c, [&](std::uint64_t key, const Value&) { ++chunk.place[key >> bucket_bits]; });
    });
    if (total > max_pairs) return std::nullopt;

    // Bucket b's pairs are those from begin[b] to before begin[b + 1].
    std::vector<std::uint64_t> begin(buckets + 1, 0);
    for (const Chunk& chunk : chunks) {
      for (std::uint64_t b = 0; b < buckets; ++b)
        begin[b + 1] += chunk.place[b];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint64_t> next(begin.begin(), begin.end() - 1);
    for (Chunk& chunk : chunks) {
      for (std::uint64_t b = 0; b < buckets; ++b)
        chunk.place[b] = std::exchange(next[b], next[b] + chunk.place[b]);
    }
    auto keys = array<std::uint64_t>(total);
    auto values = array<Value>(total);
    parallel_for(chunks.size(), [&](std::uint64_t c) {
      check_progress(progress);
      for_each_pair(c, [&](std::uint64_t key, const Value& value) {
        const std::uint64_t place = chunks[c].place[key >> bucket_bits]++;
        keys[place] = key;
        values[place] = value;
      });
      chunks[c] = {};
    });
    parallel_for(buckets, [&](std::uint64_t b) {
      if (begin[b] == begin[b + 1]) return;
      check_progress(progress);
      const std::size_t size = begin[b + 1] - begin[b];
      sort_bucket(bucket_bits, size, keys.data() + begin[b], values.data() + begin[b]);
    });
    return Sorted<HostExecutor, Value>{std::move(keys), std::move(values)};
  }

private:
  // By the keys' lowest bits: the others are the same. Equal keys stay in their order.
  template <class Value>
  static void sort_bucket(int bits, std::size_t size, std::uint64_t* keys, Value* values) {
    // A key's lowest bits, and where the pair was.
    using Place = std::uint64_t;
    std::vector<Place> places(size);
    for (std::size_t i = 0; i < size; ++i)
      places[i] = keys[i] << 32 | i;
    constexpr int most_bits = 12; // of a digit
    const int digits = (bits + most_bits - 1) / most_bits, digit_bits = (bits + digits - 1) / digits;
    if (size < (std::size_t{1} << digit_bits) / 4) { // few in many: by comparison
      std::sort(places.begin(), places.end());
    } else {
      std::vector<Place> sorted(size);
      std::vector<std::uint32_t> next(std::size_t{1} << digit_bits);
      for (int shift = 32; shift < 32 + bits; shift += digit_bits) {
        const auto digit = [=, mask = next.size() - 1](Place place) { return place >> shift & mask; };
        std::fill(next.begin(), next.end(), 0U);
        for (const Place place : places)
          ++next[digit(place)];
        std::exclusive_scan(next.begin(), next.end(), next.begin(), 0U);
        for (const Place place : places)
          sorted[next[digit(place)]++] = place;
        std::swap(places, sorted);
      }
    }
    const std::vector<Value> unsorted(values, values + size);
    const std::uint64_t high = *keys >> bits << bits;
    for (std::size_t i = 0; i < size; ++i) {
      keys[i] = high | (places[i] >> 32 & ((std::uint64_t{1} << bits) - 1));
      values[i] = unsorted[static_cast<std::uint32_t>(places[i])];
    }
  }

  template <class Act>
  void for_each_range(std::uint64_t count, std::uint64_t grain, const Act& act) const {
    in_parts(count, grain, [&](std::uint64_t begin, std::uint64_t end) {
      for (; begin != end; ++begin)
        act(begin);
    });
  }

  template <class Act>
  void in_parts(std::uint64_t count, std::uint64_t grain, const Act& act) const {
    const auto over = [&](std::uint64_t begin, std::uint64_t end) {
      for (; begin < end; begin += grain) {
        check_progress(progress);
        act(begin, std::min(end, begin + grain));
      }
    };
    if constexpr (parallel)
      parallel_ranges(count, grain, std::cref(over));
    else
      over(0, count);
  }
};

using TbbExecutor = HostExecutor<true>;
using SerialExecutor = HostExecutor<false>;

} // namespace masu
