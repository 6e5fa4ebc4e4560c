// How much memory this process may take.
#pragma once

#include <limits>
#include <string>

namespace masu {

// What this process can still allocate, in bytes: what the machine has available, or what the limits of its
// control groups (a container's, a batch job's) leave, if that is less. Infinity where neither is known.
// `root`: where proc and sys are mounted.
double available_memory(const std::string& root = "/");

// For so many bytes; for few of them infinity: to ask takes longer than to write so much.
inline double available_memory_for(double needed) {
  constexpr double few = 0x1p26;
  return needed > few ? available_memory() : std::numeric_limits<double>::infinity();
}

} // namespace masu
