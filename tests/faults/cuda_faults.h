// Makes calls of the CUDA driver fail, in the program that cuda_faults.cpp is linked to.
#pragma once

#include <cstdint>

namespace masu {

// Calls are counted from 1 again, and number n fails; with `all_after` those after it, too. 0: none.
void fail_cuda_call(std::uint64_t n, bool all_after);

// Since then.
std::uint64_t cuda_calls();

} // namespace masu
