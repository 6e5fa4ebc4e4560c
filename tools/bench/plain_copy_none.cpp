// For builds without CUDA, in which --backend cuda is refused before this is called.
#include "tools/bench/plain_copy.h"

#include "libscene/error.h"

namespace masu {

double copy_seconds_cuda(const std::string&, CopyFrom) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it: use --backend cpu");
}

} // namespace masu
