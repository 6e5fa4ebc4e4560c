// The measurements' file: a line a row, so that a run which was stopped goes on where it was.
#pragma once

#include "tools/bench/tradeoff.h"

#include <cstdio>
#include <memory>

namespace masu {

// All rows in the file; none where there is no file. A last line without its end, cut by a stop, is no row.
// Throws Error(input, path:line, …) for a file of another kind, and for a damaged line.
std::vector<TradeoffRow> read_tradeoff_csv(const std::string& path);

// Adds rows to a file that read_tradeoff_csv has read, or begins one. A row is in the file, whole, when
// add() returns. A last line that was cut is removed. Two may not write at once.
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

} // namespace masu
