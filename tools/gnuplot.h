// gnuplot, as a process.
#pragma once

#include <string>

namespace masu {

// Runs the script of that name in its folder. False where gnuplot isn't installed. Throws Error(output) when
// it fails.
bool run_gnuplot(const std::string& folder, const std::string& script);

} // namespace masu
