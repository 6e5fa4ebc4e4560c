// How much memory this process may take.
#pragma once

#include <string>

namespace masu {

// What this process can still allocate, in bytes: what the machine has available, or what the limits of its
// control groups (a container's, a batch job's) leave, if that is less. Infinity where neither is known.
// `root`: where proc and sys are mounted.
double available_memory(const std::string& root = "/");

} // namespace masu
