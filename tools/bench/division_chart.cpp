#include "tools/bench/division_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace masu {
namespace {

constexpr int division_height = 760; // pixels

constexpr std::array<Look, 8> scene_looks{{{"#000000", "1", 7},
                                           {"#d55e00", "'--'", 5},
                                           {"#0072b2", "'.'", 9},
                                           {"#009e73", "'_.'", 11},
                                           {"#cc79a7", "'-..'", 13},
                                           {"#56b4e9", "'__'", 6},
                                           {"#e69f00", "'_..'", 4},
                                           {"#666666", "'-'", 8}}};

// Uniform grids, exact overlap, proven: a line a scene over the division's voxels an axis. By robust
// arithmetic, or by what there is.
struct DivisionLine {
  std::string scene;
  Precision precision;
  std::vector<std::pair<double, double>> points; // voxels an axis (geometric mean), ms; ascending
  std::vector<std::pair<double, double>> chosen; // of the division `auto`
};

std::vector<DivisionLine> division_lines(const std::vector<TradeoffRow>& rows) {
  std::vector<DivisionLine> lines;
  for (const Precision precision : {Precision::robust, Precision::doubled, Precision::fast}) {
    for (const TradeoffRow& row : rows) {
      const Configuration& c = row.configuration;
      if (!(c == Configuration{precision, StopRule::proven, MergeChoice::none, c.division, Overlap::exact}))
        continue;
      auto line = std::find_if(lines.begin(), lines.end(),
                               [&](const DivisionLine& l) { return l.scene == row.scene; });
      if (line == lines.end()) line = lines.insert(lines.end(), {row.scene, precision, {}, {}});
      if (line->precision != precision) continue;
      (c.division == "auto" ? line->chosen : line->points)
          .emplace_back(std::cbrt(static_cast<double>(row.measured.voxels)), row.measured.picture_ms);
    }
  }
  std::erase_if(lines, [](const DivisionLine& line) { return line.points.empty(); });
  for (DivisionLine& line : lines)
    std::sort(line.points.begin(), line.points.end());
  return lines;
}

} // namespace

void write_division(ChartScript& script, const std::vector<TradeoffRow>& rows) {
  const Script out(script.text);
  const std::vector<DivisionLine> lines = division_lines(rows);
  if (lines.empty()) return;
  const TradeoffSetup& setup = rows.front().setup;
  Scale x{1, 1}, y{std::numeric_limits<double>::infinity(), 0};
  std::vector<LabelAt> labels;
  const auto widen = [&](const auto& points) {
    for (const auto& [voxels, ms] : points) {
      x.high = std::max(x.high, voxels);
      y = {std::min(y.low, ms / 1.3), std::max(y.high, ms * 1.3)};
    }
  };
  for (const DivisionLine& line : lines) {
    widen(line.points);
    widen(line.chosen);
    labels.push_back({line.points.back().first, line.points.back().second, line.scene});
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const bool chosen : {false, true}) {
      fmt::format_to(out, "${}{} << END\n", chosen ? "chosen" : "line", i);
      const auto& points = chosen ? lines[i].chosen : lines[i].points;
      for (const auto& [voxels, ms] : points)
        fmt::format_to(out, "{:g} {:g}\n", voxels, ms);
      fmt::format_to(out, "{}END\n", points.empty() ? "NaN NaN\n" : "");
    }
  }
  for (const char* const kind : {"svg", "pngcairo"}) {
    write_terminal(script, kind, "division", division_height);
    write_heading(
        out, division_height, fmt::format("Time against division ({})", backend_of(setup)),
        fmt::format("uniform grids, exact overlap, {}; pictures of {} with shadows and mirrors; ringed: "
                    "--division auto",
                    name_of(lines.front().precision), setup.picture));
    fmt::format_to(
        out,
        "set lmargin at screen 0.09; set rmargin at screen 0.88; set bmargin at screen 0.10; set tmargin at "
        "screen 0.89\nunset key\n"
        "set xrange [{:g}:{:g}]; set yrange [{:g}:{:g}]\n"
        "set xlabel 'voxels an axis'; set ylabel 'ms a picture'\n"
        "set xtics (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024)\nset ytics ({})\n"
        "set arrow from first 16, graph 0 to first 16, graph 1 nohead lw 1.5 dt '-' lc rgb '#444444'\n"
        "set label '16: what the 2012 thesis found enough' at first 16, graph 0.97 offset 1,0 left\n",
        x.low / 1.1, x.high * 1.1, y.low, y.high, log_ticks(y.low, y.high));
    write_labels(out, y, labels, 0.045);
    fmt::format_to(out, "plot ");
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Look& look = scene_looks[i % scene_looks.size()];
      fmt::format_to(out,
                     "{0}$line{1} with linespoints pt {2} ps 1.2 lw 2 dt {3} lc rgb '{4}', \\\n"
                     "     $chosen{1} with points pt {2} ps 1.2 lc rgb '{4}', \\\n"
                     "     $chosen{1} with points pt 6 ps 2.8 lw 2 lc rgb '{4}'",
                     i > 0 ? ", \\\n     " : "", i, look.point, look.dash, look.color);
    }
    fmt::format_to(out, "\nunset output\n");
  }
}

} // namespace masu
