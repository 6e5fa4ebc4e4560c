#include "tools/draw/slice_chart.h"

#include <fmt/format.h>

#include <utility>

namespace masu {
namespace {

constexpr Rgb outline_color{214, 40, 20};
constexpr double tick_length = 0.3; // in em

std::string tick_text(double tick) {
  return fmt::format("{:.6g}", tick);
}

double widest(std::span<const double> ticks, double em) {
  double width = 0;
  for (const double tick : ticks)
    width = std::max(width, text_width(tick_text(tick), em));
  return width;
}

// As many as fit a horizontal axis of so many pixels.
std::vector<double> horizontal_ticks(double low, double high, double length, double em) {
  for (int most = 9;; --most) {
    std::vector<double> ticks = linear_ticks(low, high, most);
    if (most == 2 || ticks.size() < 2) return ticks;
    if (widest(ticks, em) + em < (ticks[1] - ticks[0]) / (high - low) * length) return ticks;
  }
}

// A name along a side of the plot, in its middle; smaller where the side is short.
void draw_name(cairo_t* cairo, double x, double y, const std::string& name, double em, double side,
               TextDirection direction) {
  const double size = em * std::min(1.0, side / std::max(text_width(name, em), 1.0));
  draw_text(cairo, x, y, name, size, TextAnchor::middle, direction);
}

void draw_axes(cairo_t* cairo, const Chart& chart) {
  const Plot& plot = chart.plot;
  const DrawingBox& box = plot.box;
  const double em = plot.em, tick = tick_length * em, line = plot.line();
  for (const double at : chart.ticks[0]) {
    const double x = std::round(plot.x(at) - line / 2);
    fill_box(cairo, {x, box.bottom, x + line, box.bottom + tick}, black);
    draw_text(cairo, x + line / 2, box.bottom + tick + 1.05 * em, tick_text(at), em, TextAnchor::middle);
  }
  for (const double at : chart.ticks[1]) {
    const double y = std::round(plot.y(at) - line / 2);
    fill_box(cairo, {box.left - tick, y, box.left, y + line}, black);
    draw_text(cairo, box.left - tick - 0.25 * em, y + line / 2 + capital_height * em / 2, tick_text(at), em,
              TextAnchor::end);
  }
  draw_name(cairo, (box.left + box.right) / 2, box.bottom + tick + 2.6 * em, chart.axis_names[0], em,
            box.width(), TextDirection::right);
  draw_name(cairo, 1.5 * em, (box.top + box.bottom) / 2, chart.axis_names[1], em, box.height(),
            TextDirection::up);
}

void draw_legend(cairo_t* cairo, const Chart& chart, const ColorMap& map) {
  const double em = chart.plot.em;
  const DrawingBox& bar = chart.bar;
  if (chart.range.has_empty) {
    const DrawingBox patch{bar.left, std::round(chart.plot.box.bottom - 0.9 * em), bar.right,
                           chart.plot.box.bottom};
    draw_frame(cairo, patch, chart.plot.line());
    draw_text(cairo, bar.right + 0.5 * em, (patch.top + patch.bottom + capital_height * em) / 2, chart.white,
              em);
  }
  if (!chart.range.has_values()) return;
  const auto color = [&](double share) { return shade_of(map, chart.range.darkness_at(share)); };
  draw_color_bar(cairo, bar, color, chart.bar_labels, em);
  draw_name(cairo, chart.bar_name, (bar.top + bar.bottom) / 2, chart.range.label(), em, bar.height(),
            TextDirection::up);
}

// Cuts a segment to a box. Returns whether anything of it is left.
bool cut_to(const DrawingBox& box, Point& from, Point& to) {
  const Point d{to.x - from.x, to.y - from.y};
  double first = 0, last = 1;
  for (const auto& [step, room] : {std::pair(-d.x, from.x - box.left), std::pair(d.x, box.right - from.x),
                                   std::pair(-d.y, from.y - box.top), std::pair(d.y, box.bottom - from.y)}) {
    if (step < 0) first = std::max(first, room / step);
    if (step > 0) last = std::min(last, room / step);
    if (step == 0 && room < 0) return false;
  }
  if (!(first <= last)) return false;
  to = {from.x + last * d.x, from.y + last * d.y};
  from = {from.x + first * d.x, from.y + first * d.y};
  return true;
}

void draw_outline(cairo_t* cairo, const Chart& chart) {
  const DrawingBox& box = chart.plot.box;
  const double width = 0.1 * chart.plot.em;
  // Cairo's coordinates end at 2^23: segments reach far beyond a small window.
  const DrawingBox near{box.left - 2 * width, box.top - 2 * width, box.right + 2 * width,
                        box.bottom + 2 * width};
  cairo_save(cairo);
  cairo_rectangle(cairo, box.left, box.top, box.width(), box.height());
  cairo_clip(cairo);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  Point end{-1, -1};
  for (const CutSegment& segment : chart.outline) {
    Point from = chart.plot.point(segment.from), to = chart.plot.point(segment.to);
    if (!cut_to(near, from, to)) continue;
    if (from.x != end.x || from.y != end.y) cairo_move_to(cairo, from.x, from.y); // else a polygon goes on
    cairo_line_to(cairo, to.x, to.y);
    end = to;
  }
  set_color(cairo, white, 0.6); // readable on dark cells, and without colour
  cairo_set_line_width(cairo, 2 * width);
  cairo_stroke_preserve(cairo);
  set_color(cairo, outline_color);
  cairo_set_line_width(cairo, width);
  cairo_stroke(cairo);
  cairo_restore(cairo);
}

} // namespace

void lay_out(Chart& chart, const SliceWindow& window, std::int32_t size, const std::string& title,
             const std::string& subtitle) {
  const double em = std::max(10, size / 32), margin = 0.6 * em;
  const double u = window.max[0] - window.min[0], v = window.max[1] - window.min[1], longer = std::max(u, v);
  const double shortest = std::min<double>(7 * em, size);
  const double width = std::max(std::round(size * (u / longer)), shortest),
               height = std::max(std::round(size * (v / longer)), shortest);
  chart.ticks[0] = horizontal_ticks(window.min[0], window.max[0], width, em);
  chart.ticks[1] =
      linear_ticks(window.min[1], window.max[1], std::clamp(static_cast<int>(height / (1.8 * em)), 2, 9));

  const double legend = 1.6 * em; // a line's height
  const double bar_height = height - (chart.range.has_empty ? legend : 0);
  if (chart.range.has_values()) chart.bar_labels = color_bar_labels(chart.range.scale(), bar_height, em);
  const double bar_name = color_bar_label_width(chart.bar_labels, em) + 1.4 * em; // its baseline
  const double empty = chart.range.has_empty ? 0.5 * em + text_width(chart.white, em) : 0;

  const double left = std::ceil(margin + 1.5 * em + widest(chart.ticks[1], em) + (0.25 + tick_length) * em);
  chart.bar.left = left + width + std::round(em);
  chart.bar.right = chart.bar.left + std::round(em);
  chart.bar_name = chart.bar.right + bar_name;
  chart.width = static_cast<std::int32_t>(
      std::ceil(std::max(chart.bar_name + 0.3 * em, chart.bar.right + empty) + margin));
  chart.title = text_block(title, em, chart.width - 2 * margin);
  chart.subtitle = text_block(subtitle, 0.85 * em, chart.width - 2 * margin);
  const double top = std::ceil(margin + chart.title.height() + chart.subtitle.height() + 0.5 * em);
  chart.height = static_cast<std::int32_t>(std::ceil(top + height + (tick_length + 3.1) * em + margin));
  chart.plot = {{left, top, left + width, top + height}, window, em};
  chart.bar.top = top;
  chart.bar.bottom = top + std::round(bar_height);
}

void draw_around(cairo_t* cairo, const Chart& chart, const ColorMap& map) {
  draw_outline(cairo, chart);
  draw_frame(cairo, chart.plot.box, chart.plot.line());
  draw_axes(cairo, chart);
  draw_legend(cairo, chart, map);
  const double margin = 0.6 * chart.plot.em;
  draw_text_block(cairo, margin, margin, chart.title);
  draw_text_block(cairo, margin, margin + chart.title.height(), chart.subtitle);
}

} // namespace masu
