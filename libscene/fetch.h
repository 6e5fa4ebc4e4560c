// Reading a record whole.
#pragma once

#include "libscene/portable.h"

namespace masu {

// The record at `at`: on the device in 16-byte loads through the cache for what doesn't change, where the
// compiler would fetch member by member what is used of it.
template <class Record>
MASU_HD inline Record fetched(const Record* at) {
#ifdef __CUDA_ARCH__
  static_assert(sizeof(Record) % sizeof(uint4) == 0 && alignof(Record) >= sizeof(uint4));
  union {
    uint4 parts[sizeof(Record) / sizeof(uint4)];
    Record record;
  } copy;
#pragma unroll
  for (unsigned i = 0; i < sizeof(Record) / sizeof(uint4); ++i)
    copy.parts[i] = __ldg(reinterpret_cast<const uint4*>(at) + i);
  return copy.record;
#else
  return *at;
#endif
}

// The same of a record that is read but once, and shall not stay in a cache; in 8-byte loads.
template <class Record>
MASU_HD inline Record streamed(const Record* at) {
#ifdef __CUDA_ARCH__
  static_assert(sizeof(Record) % sizeof(uint2) == 0 && alignof(Record) >= sizeof(uint2));
  union {
    uint2 parts[sizeof(Record) / sizeof(uint2)];
    Record record;
  } copy;
#pragma unroll
  for (unsigned i = 0; i < sizeof(Record) / sizeof(uint2); ++i)
    copy.parts[i] = __ldcs(reinterpret_cast<const uint2*>(at) + i);
  return copy.record;
#else
  return *at;
#endif
}

} // namespace masu
