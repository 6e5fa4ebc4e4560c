// For builds without CUDA.
#include "libscene/cuda/host_copies.h"

#include <cstring>

namespace masu {

void copy_to_host(void* to, const void* from, std::size_t bytes, int) {
  std::memcpy(to, from, bytes);
}

} // namespace masu
