// Reading a record whole, where a GPU's compiler would fetch member by member what is used of it.
#pragma once

#include "libscene/portable.h"

namespace masu {

#ifdef __CUDACC__
// The record at `at`, read in loads of a Piece each.
template <class Piece, class Record, class Load>
__device__ inline Record read_in_parts(const Record* at, const Load& load) {
  static_assert(sizeof(Record) % sizeof(Piece) == 0 && alignof(Record) >= sizeof(Piece));
  union {
    Piece parts[sizeof(Record) / sizeof(Piece)];
    Record record;
  } copy;
#pragma unroll
  for (unsigned i = 0; i < sizeof(Record) / sizeof(Piece); ++i)
    copy.parts[i] = load(reinterpret_cast<const Piece*>(at) + i);
  return copy.record;
}
#endif

// The record at `at`: on the device in 16-byte loads through the cache for what doesn't change.
template <class Record>
MASU_HD inline Record fetched(const Record* at) {
#ifdef __CUDA_ARCH__
  return read_in_parts<uint4>(at, [](const uint4* part) { return __ldg(part); });
#else
  return *at;
#endif
}

// The same of a record that is read but once, and shall not stay in a cache; in 8-byte loads.
template <class Record>
MASU_HD inline Record streamed(const Record* at) {
#ifdef __CUDA_ARCH__
  return read_in_parts<uint2>(at, [](const uint2* part) { return __ldcs(part); });
#else
  return *at;
#endif
}

} // namespace masu
