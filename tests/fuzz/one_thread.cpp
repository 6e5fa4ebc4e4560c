// Every target runs on one thread: inputs are small, and each worker has a core.
#include <tbb/global_control.h>

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  static const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  return 0;
}
