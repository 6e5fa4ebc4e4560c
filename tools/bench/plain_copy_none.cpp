// Stands in for the copy to a device where the program was built without CUDA: --backend cuda is refused
// before.
#include "tools/bench/plain_copy.h"

#include "libscene/error.h"

namespace masu {

double copy_seconds_cuda(const std::string&, CopyFrom) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it: use --backend cpu");
}

} // namespace masu
