// What the charts have in common, as parts of a script for gnuplot.
#pragma once

#include "tools/bench/tradeoff.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace masu {

using Script = std::back_insert_iterator<std::string>;

// A script that draws charts, and the names of the files it writes into the folder it is run in. The n-th is
// written elsewhere where a variable chart_n says so.
struct ChartScript {
  std::string text;
  std::vector<std::string> files;
};

inline constexpr int chart_width = 1100; // pixels

// Colours that the colour-blind tell apart, after Okabe & Ito; shapes tell as much.
struct Look {
  const char *color, *dash;
  int point;
};

// A scale of logarithms.
struct Scale {
  double low, high;
  double place(double value) const { return std::log(value / low) / std::log(high / low); }
};

struct LabelAt {
  double x, y;
  std::string text;
};

// 65536 → 65,536.
std::string grouped(std::uint64_t number);

// GPU, or CPU with its threads.
std::string backend_of(const TradeoffSetup& setup);

// 'set xtics' for a scale of logarithms: the longer it is, the fewer a decade.
std::string log_ticks(double low, double high);

// Texts right of the plot, each at its point's height or near it, with a line that leads there. `gap` between
// them is of the plot's height.
void write_labels(Script out, const Scale& y, const std::vector<LabelAt>& labels, double gap);

// Begins a chart file of that kind.
void write_terminal(ChartScript& script, const char* kind, const std::string& name, int height);

// `height` is the chart's, in pixels.
void write_heading(Script out, int height, const std::string& title, const std::string& below);

} // namespace masu
