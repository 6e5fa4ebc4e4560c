#include "libscene/base/processor.h"

#include "libscene/base/error.h"

namespace masu {

void check_processor() {
#if defined(__x86_64__) && defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
    throw Error(ErrorCode::device, "processor", "lacks AVX2 or FMA: build with -DMASU_AVX2=OFF for it");
#endif
}

} // namespace masu
