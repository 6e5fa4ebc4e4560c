#include "tools/tradeoff_charts.h"

#include "tools/tradeoff_front.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace masu {
namespace {

using Script = std::back_insert_iterator<std::string>;

// Of the charts, in pixels.
constexpr int width = 1100, tradeoff_height = 1240, division_height = 760;

// Colours that the colour-blind tell apart, after Okabe & Ito; shapes tell as much.
struct Look {
  const char *color, *dash;
  int point;
};

// By precision, then by stop rule: filled shapes are proven, open ones the study's.
constexpr std::array<Look, 6> method_looks{{{"#d55e00", "1", 7},
                                            {"#d55e00", "1", 6},
                                            {"#0072b2", "1", 5},
                                            {"#0072b2", "1", 4},
                                            {"#009e73", "1", 9},
                                            {"#009e73", "1", 8}}};
constexpr std::array<Look, 8> scene_looks{{{"#000000", "1", 7},
                                           {"#d55e00", "'--'", 5},
                                           {"#0072b2", "'.'", 9},
                                           {"#009e73", "'_.'", 11},
                                           {"#cc79a7", "'-..'", 13},
                                           {"#56b4e9", "'__'", 6},
                                           {"#e69f00", "'_..'", 4},
                                           {"#666666", "'-'", 8}}};

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

// 65536 → 65,536.
std::string grouped(std::uint64_t number) {
  if (number < 1000) return std::to_string(number);
  return fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
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

// 'set xtics' for a scale of logarithms: the longer it is, the fewer a decade.
std::string speed_ticks(double low, double high) {
  const double length = high / low;
  const std::vector<double> factors = length > 3e3  ? std::vector<double>{1}
                                      : length > 20 ? std::vector<double>{1, 2, 5}
                                                    : std::vector<double>{1, 1.5, 2, 3, 5, 7};
  std::vector<std::string> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10, exponent) <= high;
       ++exponent) {
    for (const double factor : factors) {
      const double value = factor * std::pow(10, exponent);
      if (value >= low && value <= high) ticks.push_back(fmt::format("'{0:g}' {0:g}", value));
    }
  }
  return fmt::format("{}", fmt::join(ticks, ", "));
}

// Moves places apart, each at least `gap` from the next, within 0 to 1 where they fit; their order stays.
std::vector<double> spread(const std::vector<double>& places, double gap) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  std::vector<double> moved = places;
  double free_from = 0;
  for (const std::size_t i : order) {
    moved[i] = std::max(places[i], free_from);
    free_from = moved[i] + gap;
  }
  double free_to = 1;
  for (std::size_t k = order.size(); k-- > 0;) {
    double& place = moved[order[k]];
    place = std::min(place, free_to);
    free_to = place - gap;
  }
  return moved;
}

// A scale of logarithms.
struct Scale {
  double low, high;
  double place(double value) const { return std::log(value / low) / std::log(high / low); }
};

struct LabelAt {
  double x, y;
  std::string text;
};

// Texts right of the plot, each at its point's height or near it, with a line that leads there.
void write_labels(Script out, const Scale& y, const std::vector<LabelAt>& labels, double gap) {
  std::vector<double> places(labels.size());
  std::transform(labels.begin(), labels.end(), places.begin(),
                 [&](const LabelAt& label) { return y.place(label.y); });
  const std::vector<double> moved = spread(places, gap);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    fmt::format_to(out, "set arrow from first {:g},{:g} to graph 1.0,{:.4f} nohead lw 0.8 lc rgb '#999999'\n",
                   labels[i].x, labels[i].y, moved[i]);
    fmt::format_to(out,
                   "set arrow from graph 1.0,{0:.4f} to graph 1.015,{0:.4f} nohead lw 0.8 lc rgb '#999999'\n",
                   moved[i]);
    fmt::format_to(out, "set label '{}' at graph 1.02,{:.4f} left\n", labels[i].text, moved[i]);
  }
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
  fmt::format_to(out, "set xtics ({})\nset ytics (\"{}\" {:g}", speed_ticks(x.low, x.high), panel.zero_label,
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
                                  c.stop == StopRule::proven ? "" : ", study", grid_of(c))});
  }
  write_labels(out, y, labels, 0.05);
  for (std::size_t method = 0; method < method_looks.size(); ++method)
    write_points(out, panel, fmt::format("{}{}", panel.name, method),
                 [&](std::size_t i) { return method_place(panel.rows[i].configuration) == method; });
  fmt::format_to(out, "${}_front << END\n", panel.name);
  for (std::size_t k = front.size(); k-- > 0;) // to the right
    fmt::format_to(out, "{:g} {:g}\n", drawn(panel, front[k]).speed, drawn(panel, front[k]).error);
  fmt::format_to(out, "END\nplot ");
  constexpr std::array<const char*, 6> titles{
      "fast", "fast, study''s rule", "robust", "robust, study''s rule", "double", "double, study''s rule"};
  for (std::size_t method = 0; method < method_looks.size(); ++method)
    fmt::format_to(out, "${}{} with points pt {} ps 1.3 lw 1.6 lc rgb '{}' title '{}', \\\n     ", panel.name,
                   method, method_looks[method].point, method_looks[method].color, titles[method]);
  fmt::format_to(out,
                 "NaN with lines lw 1.8 dt '-' lc rgb '#222222' title 'Pareto front', \\\n"
                 "     ${0}_front with fsteps lw 1.8 dt '-' lc rgb '#222222' notitle, \\\n"
                 "     ${0}_front with points pt 6 ps 2.6 lw 1.6 lc rgb '#222222' notitle\n",
                 panel.name);
}

// Begins a chart file of that kind.
void write_terminal(Script out, const char* kind, const std::string& name, int height) {
  fmt::format_to(
      out, "\nreset\nset terminal {} size {},{} font 'DejaVu Sans,{}' noenhanced background rgb 'white'\n",
      kind, width, height, std::string_view(kind) == "svg" ? 15 : 12);
  fmt::format_to(out,
                 "set output '{}.{}'\nset encoding utf8\nset logscale xy\nset border 3 lc rgb '#444444'\n"
                 "set tics nomirror\nset grid lc rgb '#d4d4d4' lw 1 dt 1\n",
                 name, std::string_view(kind) == "svg" ? "svg" : "png");
}

// `height` is the chart's, in pixels.
void write_heading(Script out, int height, const std::string& title, const std::string& below) {
  const auto from_top = [&](double pixels) { return 1 - pixels / height; };
  fmt::format_to(out,
                 "set label '{}' at screen 0.02, screen {:.4f} font ',20'\n"
                 "set label '{}' at screen 0.02, screen {:.4f}\n",
                 title, from_top(28), below, from_top(60));
}

std::string backend_of(const TradeoffSetup& setup) {
  if (setup.backend == "cuda") return "GPU";
  return fmt::format("CPU, {} thread{}", setup.threads, setup.threads == 1 ? "" : "s");
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

void write_tradeoff(Script out, const std::string& name, const std::string& title,
                    const std::vector<TradeoffRow>& rows) {
  const TradeoffSetup& setup = rows.front().setup;
  const std::vector<TradeoffRow> shown = without_slow(rows);
  const Panel hits = hits_panel(shown), picture = picture_panel(shown);
  for (const char* const kind : {"svg", "pngcairo"}) {
    write_terminal(out, kind, name, tradeoff_height);
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

void write_division(Script out, const std::vector<TradeoffRow>& rows) {
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
    write_terminal(out, kind, "division", division_height);
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
        "set label '16: what the founding study found enough' at first 16, graph 0.97 offset 1,0 left\n",
        x.low / 1.1, x.high * 1.1, y.low, y.high, speed_ticks(y.low, y.high));
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

} // namespace

std::string charts_script(const std::vector<TradeoffRow>& rows) {
  std::string text = "# Written by gridbench tradeoff. Run it in its folder: gnuplot tradeoff.gp\n";
  const Script out(text);
  std::vector<std::string> scenes;
  for (const TradeoffRow& row : rows) {
    if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  for (const std::string& scene : scenes) {
    std::vector<TradeoffRow> its;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(its),
                 [&](const TradeoffRow& row) { return row.scene == scene; });
    write_tradeoff(out, scene, scene, its);
  }
  const std::vector<TradeoffRow> all = over_all_scenes(rows);
  if (scenes.size() > 1 && !all.empty())
    write_tradeoff(out, "tradeoff", fmt::format("mean of {} scenes", scenes.size()), all);
  write_division(out, rows);
  return text;
}

} // namespace masu
