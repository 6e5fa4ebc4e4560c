// Charts of the measurements, as a script for gnuplot.
#pragma once

#include "tools/bench/chart.h"
#include "tools/bench/tradeoff.h"

#include <vector>

namespace masu {

// A script with its data in it, which writes into the folder that it is run in, as SVG and as PNG: for each
// scene speed against accuracy, hits above and the picture below, with the Pareto fronts; the same of all
// scenes together (tradeoff_front.h: over_all_scenes) where there are several; and division_chart.h's.
// All rows must be of one setup. What is right to the last ray can't be drawn on a scale of logarithms: it
// lies in a band of its own, where half a ray of those compared would be.
ChartScript charts_script(const std::vector<TradeoffRow>& rows);

} // namespace masu
