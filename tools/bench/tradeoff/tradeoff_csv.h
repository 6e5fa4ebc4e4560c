// The file of measurements: one line a row, so that a run that was stopped is continued by the next one.
#pragma once

#include "tools/bench/tradeoff/tradeoff.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace masu {

// All rows in the file; none where there is no file. An incomplete last line, left by a run that was stopped,
// is ignored. Throws Error(input, path:line, …) for a file of another kind, and for a damaged line.
std::vector<TradeoffRow> read_tradeoff_csv(const std::string& path);

// Appends rows to a file that read_tradeoff_csv accepts, or creates one. The whole row is in the file when
// add() returns. An incomplete last line is removed. The file is locked: only one run at a time may write it.
class TradeoffCsv {
public:
  // Throws Error(output, path, …).
  explicit TradeoffCsv(std::string path);
  void add(const TradeoffRow& row);

private:
  struct Close {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
  };
  void write(const std::string& line);

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

// A row with the file's names.
nlohmann::ordered_json json_of(const TradeoffRow& row);

// The rows that the charts show, a group for each chart, with two more columns: hits_front and picture_front
// are 1 for rows on the group's Pareto fronts (merit_of_hits, merit_of_picture), else 0. Throws Error(output,
// path, …).
void write_charts_csv(const std::string& path, const std::vector<std::vector<TradeoffRow>>& groups);

} // namespace masu
