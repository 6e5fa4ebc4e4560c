#include "tools/bench/tradeoff_charts.h"

#include "tools/bench/division_chart.h"
#include "tools/bench/tradeoff_front.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace masu {
namespace {

constexpr int tradeoff_height = 1240; // pixels

// By precision, then by stop rule: filled shapes are proven, open ones end with the first cell.
constexpr std::array<Look, 6> method_looks{{{"#d55e00", "1", 7},
                                            {"#d55e00", "1", 6},
                                            {"#0072b2", "1", 5},
                                            {"#0072b2", "1", 4},
                                            {"#009e73", "1", 9},
                                            {"#009e73", "1", 8}}};

std::size_t precision_place(const Configuration& configuration) {
  switch (configuration.precision) {
  case Precision::fast:
    return 0;
  case Precision::robust:
    return 1;
  default:
    return 2;
  }
}
std::size_t method_place(const Configuration& configuration) {
  return 2 * precision_place(configuration) + (configuration.stop == StopRule::proven ? 0 : 1);
}

// A power of ten.
std::string power(int exponent) {
  constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}
// A tick's text is a format to gnuplot.
std::string percentage(int exponent) {
  return fmt::format("{:.{}f} %%", std::pow(10, exponent + 2), std::max(0, -exponent - 2));
}

// Speed against error.
struct Panel {
  std::string name, x_label, y_label, zero_label;
  const std::vector<TradeoffRow>& rows;
  std::vector<Merit> merits;
  double zero; // where an error of zero is drawn
  std::string (*tick)(int exponent);
};

Panel hits_panel(const std::vector<TradeoffRow>& rows) {
  Panel panel{"hits", "million nearest hits a second", "wrong hits", "", rows, {}, 0, percentage};
  std::uint64_t rays = 1;
  for (const TradeoffRow& row : rows) {
    panel.merits.push_back(merit_of_hits(row));
    rays = std::max(rays, row.measured.accuracy.rays);
  }
  panel.zero = 0.5 / static_cast<double>(rays);
  panel.zero_label = fmt::format("none of\\n{}", grouped(rays));
  return panel;
}

Panel picture_panel(const std::vector<TradeoffRow>& rows) {
  Panel panel{"picture", "pictures a second", "picture: RMSE of a channel", "same\\nbits", rows, {}, 1e-9,
              power};
  double least = std::numeric_limits<double>::infinity();
  for (const TradeoffRow& row : rows) {
    panel.merits.push_back(merit_of_picture(row));
    if (panel.merits.back().error > 0) least = std::min(least, panel.merits.back().error);
  }
  if (std::isfinite(least)) panel.zero = least / 8;
  return panel;
}

struct Scales {
  Scale x, y;
};

Scales scales_of(const Panel& panel) {
  Scales scales{{std::numeric_limits<double>::infinity(), 0}, {panel.zero / 2.5, panel.zero * 40}};
  for (const Merit& merit : panel.merits) {
    scales.x.low = std::min(scales.x.low, merit.speed / 1.2);
    scales.x.high = std::max(scales.x.high, merit.speed * 1.2);
    scales.y.high = std::max(scales.y.high, merit.error * 2.5);
  }
  return scales;
}

// Where a row is drawn. In the band of those without errors precisions lie beside each other.
Merit drawn(const Panel& panel, std::size_t row) {
  const Merit& merit = panel.merits[row];
  if (merit.error > 0) return merit;
  const auto precision = static_cast<double>(precision_place(panel.rows[row].configuration));
  return {merit.speed, panel.zero * std::pow(1.35, 1 - precision)};
}

// A data block of the rows that `wanted` holds for.
template <class Wanted>
void write_points(Script out, const Panel& panel, const std::string& name, const Wanted& wanted) {
  fmt::format_to(out, "${} << END\n", name);
  bool any = false;
  for (std::size_t i = 0; i < panel.rows.size(); ++i) {
    if (!wanted(i)) continue;
    any = true;
    fmt::format_to(out, "{:g} {:g}\n", drawn(panel, i).speed, drawn(panel, i).error);
  }
  fmt::format_to(out, "{}END\n", any ? "" : "NaN NaN\n");
}

template <class Heading>
void write_panel(Script out, const Panel& panel, double bottom, double top, const Heading& heading) {
  const auto [x, y] = scales_of(panel);
  const std::vector<std::size_t> front = pareto_front(panel.merits);
  fmt::format_to(out,
                 "\nunset label; unset arrow; unset object\n"
                 "set lmargin at screen 0.115; set rmargin at screen 0.735\n"
                 "set bmargin at screen {}; set tmargin at screen {}\n"
                 "set xrange [{:g}:{:g}]; set yrange [{:g}:{:g}]\n"
                 "set xlabel '{}  (more is better)'; set ylabel '{}  (less is better)' offset -1.5\n",
                 bottom, top, x.low, x.high, y.low, y.high, panel.x_label, panel.y_label);
  heading();
  fmt::format_to(out, "set xtics ({})\nset ytics (\"{}\" {:g}", log_ticks(x.low, x.high), panel.zero_label,
                 panel.zero);
  for (int exponent = static_cast<int>(std::ceil(std::log10(panel.zero * 2)));
       std::pow(10, exponent) <= y.high; ++exponent)
    fmt::format_to(out, ", '{}' 1e{}", panel.tick(exponent), exponent);
  fmt::format_to(out,
                 ")\nset object rectangle from graph 0, graph 0 to graph 1, first {:g} fs solid noborder "
                 "fc rgb '#eeeeee' behind\n",
                 panel.zero * 1.7);
  std::vector<LabelAt> labels;
  for (const std::size_t i : front) {
    const Configuration& c = panel.rows[i].configuration;
    labels.push_back({drawn(panel, i).speed, drawn(panel, i).error,
                      fmt::format("{}{}: {}", name_of(c.precision),
                                  c.stop == StopRule::proven ? "" : ", first cell", grid_of(c))});
  }
  write_labels(out, y, labels, 0.05);
  for (std::size_t method = 0; method < method_looks.size(); ++method)
    write_points(out, panel, fmt::format("{}{}", panel.name, method),
                 [&](std::size_t i) { return method_place(panel.rows[i].configuration) == method; });
  fmt::format_to(out, "${}_front << END\n", panel.name);
  for (std::size_t k = front.size(); k-- > 0;) // to the right
    fmt::format_to(out, "{:g} {:g}\n", drawn(panel, front[k]).speed, drawn(panel, front[k]).error);
  fmt::format_to(out, "END\nplot ");
  constexpr std::array<const char*, 6> titles{"fast",   "fast, first cell",  "robust", "robust, first cell",
                                              "double", "double, first cell"};
  for (std::size_t method = 0; method < method_looks.size(); ++method)
    fmt::format_to(out, "${}{} with points pt {} ps 1.3 lw 1.6 lc rgb '{}' title '{}', \\\n     ", panel.name,
                   method, method_looks[method].point, method_looks[method].color, titles[method]);
  fmt::format_to(out,
                 "NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \\\n"
                 "     ${0}_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \\\n"
                 "     ${0}_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle\n",
                 panel.name);
}

// Rows far slower than the fastest would only squeeze the others together.
constexpr double slowest_shown = 1.0 / 20;
std::vector<TradeoffRow> without_slow(const std::vector<TradeoffRow>& rows) {
  double fastest = 0;
  for (const TradeoffRow& row : rows)
    fastest = std::max(fastest, row.measured.mrays);
  std::vector<TradeoffRow> kept;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept),
               [&](const TradeoffRow& row) { return row.measured.mrays >= fastest * slowest_shown; });
  return kept;
}

void write_tradeoff(ChartScript& script, const std::string& name, const std::string& title,
                    const std::vector<TradeoffRow>& rows) {
  const Script out(script.text);
  const TradeoffSetup& setup = rows.front().setup;
  const std::vector<TradeoffRow> shown = without_slow(rows);
  const Panel hits = hits_panel(shown), picture = picture_panel(shown);
  for (const char* const kind : {"svg", "pngcairo"}) {
    write_terminal(script, kind, name, tradeoff_height);
    fmt::format_to(out, "set multiplot\nset key at screen 0.05, screen 0.925 left top Left reverse vertical "
                        "maxrows 2 samplen 2\n");
    const auto heading = [&] {
      write_heading(
          out, tradeoff_height, fmt::format("{}: speed against accuracy ({})", title, backend_of(setup)),
          fmt::format("{} primary and {} random rays a scene; {} in all compared with brute force in "
                      "double; pictures of {}",
                      setup.size, grouped(setup.random), grouped(rows.front().measured.accuracy.rays),
                      setup.picture));
    };
    write_panel(out, hits, 0.50, 0.855, heading);
    fmt::format_to(out, "unset key\n");
    write_panel(out, picture, 0.065, 0.42, [] {});
    fmt::format_to(out, "unset multiplot\nunset output\n");
  }
}

} // namespace

ChartScript charts_script(const std::vector<TradeoffRow>& rows) {
  ChartScript script{"# Written by gridbench tradeoff. Run it in its folder: gnuplot tradeoff.gp\n", {}};
  std::vector<std::string> scenes;
  for (const TradeoffRow& row : rows) {
    if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  for (const std::string& scene : scenes) {
    std::vector<TradeoffRow> its;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(its),
                 [&](const TradeoffRow& row) { return row.scene == scene; });
    write_tradeoff(script, scene, scene, its);
  }
  const std::vector<TradeoffRow> all = over_all_scenes(rows);
  if (scenes.size() > 1 && !all.empty())
    write_tradeoff(script, "tradeoff", fmt::format("mean of {} scenes", scenes.size()), all);
  write_division(script, rows);
  return script;
}

} // namespace masu
