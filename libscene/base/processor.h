// What the program was compiled for.
#pragma once

#include "libscene/base/error.h"

namespace masu {

// Throws Error(device) where the processor lacks instructions that this program was compiled for.
inline void check_processor() {
#if defined(__x86_64__) && defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
    throw Error(ErrorCode::device, "processor", "lacks AVX2 or FMA: build with -DMASU_AVX2=OFF for it");
#endif
}

} // namespace masu
