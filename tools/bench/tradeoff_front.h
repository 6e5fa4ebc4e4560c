// What is worth choosing: rows that no other row is better than.
#pragma once

#include "tools/bench/tradeoff.h"

#include <vector>

namespace masu {

// How good a row is: more speed is better, less error is.
struct Merit {
  double speed, error;
};

// Whether `a` is at least as good in both, and better in one.
inline bool dominates(const Merit& a, const Merit& b) {
  return a.speed >= b.speed && a.error <= b.error && (a.speed > b.speed || a.error < b.error);
}

// The places of those that none dominates (the Pareto front), from the fastest on: errors then fall from one
// to the next. Of equals, the first.
std::vector<std::size_t> pareto_front(const std::vector<Merit>& merits);

// The share of wrong hits, by millions of rays a second.
Merit merit_of_hits(const TradeoffRow& row);
// The picture's RMSE, by pictures a second.
Merit merit_of_picture(const TradeoffRow& row);

// One row for each configuration that all scenes have: of speeds and times the geometric mean, of hits and
// bytes the sum, of errors of t the largest, the RMSE of all pictures together. Scenes are told apart by
// name.
std::vector<TradeoffRow> over_all_scenes(const std::vector<TradeoffRow>& rows);

} // namespace masu
