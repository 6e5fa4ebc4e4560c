#include "tools/bench/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace masu {
namespace {

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

} // namespace

std::string grouped(std::uint64_t number) {
  if (number < 1000) return std::to_string(number);
  return fmt::format("{},{:03}", grouped(number / 1000), number % 1000);
}

std::string backend_of(const TradeoffSetup& setup) {
  if (setup.backend == "cuda") return "GPU";
  return fmt::format("CPU, {} thread{}", setup.threads, setup.threads == 1 ? "" : "s");
}

std::string log_ticks(double low, double high) {
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

void write_terminal(ChartScript& script, const char* kind, const std::string& name, int height) {
  const Script out(script.text);
  const std::size_t number = script.files.size();
  script.files.push_back(name + (std::string_view(kind) == "svg" ? ".svg" : ".png"));
  fmt::format_to(
      out, "\nreset\nset terminal {} size {},{} font 'DejaVu Sans,{}' noenhanced background rgb 'white'\n",
      kind, chart_width, height, std::string_view(kind) == "svg" ? 15 : 12);
  fmt::format_to(out,
                 "set output exists('chart_{0}') ? chart_{0} : '{1}'\nset encoding utf8\nset logscale xy\n"
                 "set border 3 lc rgb '#444444'\nset tics nomirror\nset grid lc rgb '#d4d4d4' lw 1 dt 1\n",
                 number, script.files.back());
}

void write_heading(Script out, int height, const std::string& title, const std::string& below) {
  const auto from_top = [&](double pixels) { return 1 - pixels / height; };
  fmt::format_to(out,
                 "set label '{}' at screen 0.02, screen {:.4f} font ',20'\n"
                 "set label '{}' at screen 0.02, screen {:.4f}\n",
                 title, from_top(28), below, from_top(60));
}

} // namespace masu
