// The time of a picture against a uniform grid's division.
#pragma once

#include "tools/bench/chart.h"

namespace masu {

// A line a scene, by the exact overlap test and robust arithmetic (or double, or fast, where there is no
// other); as division.svg and division.png. Nothing where no row is of that kind.
void write_division(ChartScript& script, const std::vector<TradeoffRow>& rows);

} // namespace masu
