// Vector loads of whole records on a GPU, whose compiler would load each used member by itself; on a CPU what
// is needed soon.
#pragma once

#include "libscene/base/portable.h"

namespace masu {

#ifdef __CUDACC__
// *record, loaded in units of Piece by load(const Piece*).
template <class Piece, class Record, class Load>
__device__ inline Record load_in_pieces(const Record* record, const Load& load) {
  static_assert(sizeof(Record) % sizeof(Piece) == 0 && alignof(Record) >= sizeof(Piece));
  struct Pieces {
    Piece pieces[sizeof(Record) / sizeof(Piece)];
  } copy;
#pragma unroll
  for (unsigned i = 0; i < sizeof(Record) / sizeof(Piece); ++i)
    copy.pieces[i] = load(reinterpret_cast<const Piece*>(record) + i);
  return __builtin_bit_cast(Record, copy);
}
#endif

// *record; on the device in 16-byte loads through the read-only cache. What comes from memory brings along
// what lies beside it, 128 bytes in all: neighbours are soon wanted.
template <class Record>
MASU_HD inline Record fetched(const Record* record) {
#ifdef __CUDA_ARCH__
  return load_in_pieces<uint4>(record, [](const uint4* piece) {
    uint4 loaded;
    asm("ld.global.nc.L2::128B.v4.u32 {%0, %1, %2, %3}, [%4];"
        : "=r"(loaded.x), "=r"(loaded.y), "=r"(loaded.z), "=r"(loaded.w)
        : "l"(piece));
    return loaded;
  });
#else
  return *record;
#endif
}

// The same for a record that is read only once: 16-byte streaming loads (ld.global.cs), evicted first.
template <class Record>
MASU_HD inline Record streamed(const Record* record) {
#ifdef __CUDA_ARCH__
  return load_in_pieces<uint4>(record, [](const uint4* piece) { return __ldcs(piece); });
#else
  return *record;
#endif
}

// Of a record that is needed soon, of no more than two cache lines; nothing on the device. Inline always: GCC
// 12 takes calls of a function that only prefetches for calls without effect, and drops them.
template <class Record>
MASU_ALWAYS_INLINE void prefetch([[maybe_unused]] const Record* record) {
#ifndef __CUDA_ARCH__
  __builtin_prefetch(record);
  __builtin_prefetch(reinterpret_cast<const char*>(record + 1) - 1);
#endif
}

} // namespace masu
