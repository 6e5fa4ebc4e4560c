// gnuplot, as a process.
#pragma once

#include "tools/bench/chart.h"

#include <string>

namespace masu {

// Writes the script into the folder under that name, and the charts that it draws beside it: each whole or
// not at all. False where gnuplot isn't installed. Throws Error(output), also where gnuplot fails.
bool draw_charts(const ChartScript& script, const std::string& folder, const std::string& name);

} // namespace masu
