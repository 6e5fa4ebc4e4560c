// gnuplot, as a process.
#pragma once

#include <string>
#include <vector>

namespace masu {

// Runs a script on the folder's file `data`, whose path it finds in its variable `data`. Of the charts with
// these names it may draw some; it finds where to write them in its variable `outputs`, in pairs: NAME PATH
// NAME PATH … (no spaces in either). They appear in the folder whole or not at all. False where gnuplot isn't
// installed. Throws Error(output), also where gnuplot fails.
bool draw_charts(const std::string& script, const std::string& folder, const std::string& data,
                 const std::vector<std::string>& names);

} // namespace masu
