// For builds without CUDA, in which --backend cuda is refused before this is called.
#include "tools/bench/load/plain_copy.h"

#include "libscene/base/error.h"

namespace masu {

double copy_seconds_cuda(const std::string&, CopyFrom) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it: use --backend cpu");
}

std::shared_ptr<void> host_memory_cuda(std::size_t) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it");
}

double round_trip_seconds_cuda(const void*, std::size_t, void*, std::size_t, int, bool, int) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it");
}

} // namespace masu
