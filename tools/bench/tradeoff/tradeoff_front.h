// Pareto fronts: the rows that no other row is better than.
#pragma once

#include "tools/bench/tradeoff/tradeoff.h"

#include <vector>

namespace masu {

// How good a row is: more speed is better, less error is better.
struct Merit {
  double speed, error;
};

// Indices of those that none dominates (is at least as good in both, and better in one), in order of falling
// speed, and so of falling error. Of equals, the first.
std::vector<std::size_t> pareto_front(const std::vector<Merit>& merits);

// Closest hits: millions of rays a second, and the fraction of wrong hits.
Merit merit_of_hits(const TradeoffRow& row);
// Pictures: pictures a second, and the RMSE.
Merit merit_of_picture(const TradeoffRow& row);

// The front of rows by one of these. Rows that stop at the first cell hit are never on it: where their hits
// are right, that is by chance.
std::vector<std::size_t> front_of(const std::vector<TradeoffRow>& rows, Merit (*merit)(const TradeoffRow&));

// The mean over scenes, which are distinguished by name: one row, of a scene named `all`, for each
// configuration that was measured on every scene. Speeds and times are geometric means; counts of hits and
// bytes are sums; errors of t are maxima; the RMSE is that of all pictures together.
std::vector<TradeoffRow> over_all_scenes(const std::vector<TradeoffRow>& rows);

} // namespace masu
