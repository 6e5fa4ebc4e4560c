#include "tools/draw/slice_picture.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"
#include "tools/common/json.h"
#include "tools/common/version.h"
#include "tools/draw/axis_ticks.h"
#include "tools/draw/drawing.h"
#include "tools/report/slice_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace masu {
namespace {

constexpr Rgb outline_color{214, 40, 20};
constexpr std::size_t most_svg_cells = std::size_t{1} << 18;

// --- Values and their colours ----------------------------------------------------------------------------

// A cell's value; none for those that list nothing, coloured by references. Volumes are in voxels of the
// division.
std::optional<double> value_of(const SliceCell& cell, SliceColor color, std::int32_t nested_log2) {
  switch (color) {
  case SliceColor::volume:
    return std::ldexp(static_cast<double>(cell.voxels), -3 * nested_log2);
  case SliceColor::depth:
    return cell.depth;
  default:
    if (cell.references == 0) return std::nullopt;
    return cell.references;
  }
}

// From the least to the greatest value of the cells shown, or what SliceStyle::high says.
struct ValueRange {
  SliceColor color;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool has_empty = false;

  void include(std::optional<double> value) {
    if (value) {
      low = std::min(low, *value);
      high = std::max(high, *value);
    } else {
      has_empty = true;
    }
  }
  bool has_values() const { return low <= high; }
  ColorScale scale() const {
    const bool is_volume = color == SliceColor::volume;
    return {low, high, is_volume || (color == SliceColor::references && high > 16), 0, !is_volume};
  }
  // How dark: few references, large and undivided cells are light.
  double darkness_at(double share) const {
    if (!(high > low)) return 0.25;
    return color == SliceColor::volume ? 1 - share : share;
  }
  const char* label() const {
    return color == SliceColor::references ? "references"
           : color == SliceColor::volume   ? "cell volume (voxels)"
                                           : "depth of nesting";
  }
};

// The map from light to dark, so that white, which means empty, is next to the least value.
Rgb shade_of(const ColorMap& map, double darkness) {
  return map(1 - darkness);
}

bool is_light(Rgb color) {
  return 2 * color[0] + 5 * color[1] + color[2] > 8 * 110;
}

// --- Where things are ------------------------------------------------------------------------------------

struct Point {
  double x, y;
};

// Scene units to pixels. Both axes have the same scale unless the plot would be too flat for its labels.
struct Plot {
  DrawingBox box;
  SliceWindow window;
  double em; // the text's size, in pixels

  double x(double u) const {
    return box.left + (u - window.min[0]) / (window.max[0] - window.min[0]) * box.width();
  }
  double y(double v) const {
    return box.bottom - (v - window.min[1]) / (window.max[1] - window.min[1]) * box.height();
  }
  Point point(const std::array<double, 2>& at) const { return {x(at[0]), y(at[1])}; }
  double line() const { return std::max(1.0, std::round(em / 16)); } // the width of frames and ticks
};

// A cell's part in the plot.
DrawingBox box_of(const Plot& plot, const GridLayout& finest, int axis, const SliceCell& cell) {
  const SliceWindow scene = in_scene(finest, axis, cell);
  const DrawingBox& in = plot.box;
  return {std::clamp(plot.x(scene.min[0]), in.left, in.right),
          std::clamp(plot.y(scene.max[1]), in.top, in.bottom),
          std::clamp(plot.x(scene.max[0]), in.left, in.right),
          std::clamp(plot.y(scene.min[1]), in.top, in.bottom)};
}

// --- Cells -----------------------------------------------------------------------------------------------

// Whole pixels, at least one each way within the plot.
DrawingBox on_pixels(const DrawingBox& box, const DrawingBox& plot) {
  const double left = std::min(std::round(box.left), plot.right - 1),
               top = std::min(std::round(box.top), plot.bottom - 1);
  return {left, top, std::max(std::round(box.right), left + 1), std::max(std::round(box.bottom), top + 1)};
}

// Cells by how dark they are, and those that have lines: on their left and lower sides, which neighbours that
// fill the plot share, or on all sides.
class SliceCells {
public:
  explicit SliceCells(bool all_sides) : all_sides_(all_sides) {}

  // `darkness`: of empty cells none. No lines where they would leave hardly anything.
  void add(const DrawingBox& box, std::optional<double> darkness, bool with_lines) {
    constexpr double room_for_lines = 4;
    const Rgb color = darkness ? shade_of(map_, *darkness) : white;
    if (darkness) cells_[std::lround(*darkness * most_shade)].push_back(box);
    if (with_lines && box.width() >= room_for_lines && box.height() >= room_for_lines)
      (is_light(color) ? with_dark_lines_ : with_light_lines_).push_back(box);
  }

  // From light to dark: a pixel shows the darkest of its cells.
  void draw(cairo_t* cairo, double line_width) const {
    cairo_save(cairo);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE); // else the page shines through where cells meet
    for (const auto& [shade, boxes] : cells_) {
      for (const DrawingBox& box : boxes)
        cairo_rectangle(cairo, box.left, box.top, box.width(), box.height());
      set_color(cairo, shade_of(map_, static_cast<double>(shade) / most_shade));
      cairo_fill(cairo);
    }
    cairo_restore(cairo);
    draw_lines(cairo, with_dark_lines_, black, line_width);
    draw_lines(cairo, with_light_lines_, white, line_width);
  }
  const ColorMap& map() const { return map_; }

private:
  static constexpr long most_shade = 1023; // the map has so many steps

  // Within the boxes.
  void draw_lines(cairo_t* cairo, const std::vector<DrawingBox>& boxes, Rgb color, double width) const {
    for (const DrawingBox& box : boxes) {
      if (all_sides_) {
        cairo_rectangle(cairo, box.left + width / 2, box.top + width / 2, box.width() - width,
                        box.height() - width);
        continue;
      }
      cairo_move_to(cairo, box.left + width / 2, box.top);
      cairo_line_to(cairo, box.left + width / 2, box.bottom - width / 2);
      cairo_line_to(cairo, box.right, box.bottom - width / 2);
    }
    set_color(cairo, color, 0.4);
    cairo_set_line_width(cairo, width);
    cairo_stroke(cairo);
  }

  bool all_sides_;
  ColorMap map_ = ColorMap::of_lists();
  std::map<long, std::vector<DrawingBox>> cells_; // by darkness
  std::vector<DrawingBox> with_dark_lines_, with_light_lines_;
};

// --- Axes, legend and outline ----------------------------------------------------------------------------

// What is drawn around the cells.
struct Chart {
  Plot plot{};
  std::int32_t width = 0, height = 0; // of the page
  ValueRange range;
  std::string white; // what it means
  TextBlock title{}, subtitle{};
  std::array<std::string, 2> axis_names; // with units
  std::array<std::vector<double>, 2> ticks{};
  DrawingBox bar{};
  double bar_name = 0; // x of its baseline
  std::vector<ColorBarLabel> bar_labels{};
  std::span<const CutSegment> outline;
};

constexpr double tick_length = 0.3; // in em

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

// The places of everything, in a page whose plot has `size` pixels along its longer side.
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

void draw_chart(cairo_t* cairo, const Chart& chart, const SliceCells& cells) {
  cells.draw(cairo, chart.plot.line());
  draw_outline(cairo, chart);
  draw_frame(cairo, chart.plot.box, chart.plot.line());
  draw_axes(cairo, chart);
  draw_legend(cairo, chart, cells.map());
  const double margin = 0.6 * chart.plot.em;
  draw_text_block(cairo, margin, margin, chart.title);
  draw_text_block(cairo, margin, margin + chart.title.height(), chart.subtitle);
}

std::string by_by(const Vec3i& n) {
  return fmt::format("{} x {} x {}", n.x, n.y, n.z);
}

std::string title_of(const StructureFile& file, const SlicePlane& plane, const GridLayout& finest) {
  const std::string title =
      fmt::format("{}, {} = {:.5g}", std::filesystem::path(file.path()).filename().string(),
                  "xyz"[plane.axis], plane.position);
  return file.is_hierarchy()
             ? title
             : fmt::format("{} (layer {} of {})", title, plane.layer, finest.division[plane.axis]);
}

const char* kind_of(fb::Merge merge) {
  switch (merge) {
  case fb::Merge::none:
    return "uniform grid";
  case fb::Merge::x:
    return "grid merged along x";
  case fb::Merge::balance:
    return "grid merged by balance";
  default:
    return "irregular grid";
  }
}

std::string subtitle_of(const StructureFile& file, const SliceWindow& window, bool has_outline) {
  std::string text = file.is_hierarchy() ? fmt::format("hierarchy, {} nodes", file.nodes().size())
                                         : fmt::format("{}, {} voxels", kind_of(file.table().merge()),
                                                       by_by(file.layout().division));
  if (file.table().nested_log2() > 0) text += fmt::format(", nested 2^{}", file.table().nested_log2());
  if (window.depth)
    text += fmt::format(", {} of depth {}", file.is_hierarchy() ? "boxes" : "cells", *window.depth);
  return text + (has_outline ? "; red: geometry" : "");
}

} // namespace

void write_slice(const StructureFile& file, const SlicePlane& plane, const SliceWindow& window,
                 std::span<const CutSegment> outline, const SliceStyle& style, const std::string& path) {
  const bool is_svg = path.ends_with(".svg");
  if (path.ends_with(".json")) {
    auto json = slice_json(file, plane, window, outline);
    json.update(program_version());
    return write_text_file(path, json_text(json, -1) + "\n");
  }
  const GridLayout finest = finest_layout(file);
  const auto nested_log2 = static_cast<std::int32_t>(file.table().nested_log2());
  const bool is_hierarchy = file.is_hierarchy();
  if (is_hierarchy && style.color == SliceColor::volume)
    throw Error(ErrorCode::usage, "--color", "volume needs a grid of cells: a hierarchy has none");
  const auto value = [&](const SliceCell& cell) { return value_of(cell, style.color, nested_log2); };
  ValueRange range{style.color};
  range.has_empty = is_hierarchy || window.depth; // white shows between the rectangles
  std::size_t count = 0;
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
    range.include(value(cell));
    ++count;
  });
  if (style.high > 0) {
    range.low = style.color == SliceColor::references ? 1 : 0;
    range.high = style.high;
  }
  if (is_svg && count > most_svg_cells)
    throw Error(ErrorCode::usage, path,
                fmt::format("an SVG of {} cells is too large: give a --window, or write a PNG", count));

  const auto axis_name = [&](std::size_t i) {
    return fmt::format("{} (scene units)", "xyz"[slice_axes(plane.axis)[i]]);
  };
  const std::string title = style.title.empty() ? title_of(file, plane, finest) : style.title;
  Chart chart{.range = range,
              .white = window.depth ? "none" : "empty",
              .axis_names = {axis_name(0), axis_name(1)},
              .outline = outline};
  const std::string subtitle = subtitle_of(file, window, !outline.empty());
  lay_out(chart, window, style.size, title, subtitle);
  const ColorScale scale = range.scale();
  SliceCells cells(is_hierarchy || window.depth);
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
    const std::optional<double> shown = value(cell);
    const DrawingBox box = box_of(chart.plot, finest, plane.axis, cell);
    cells.add(is_svg ? box : on_pixels(box, chart.plot.box),
              shown ? std::optional(range.darkness_at(scale.share(*shown))) : std::nullopt,
              style.lines || (is_hierarchy && !shown)); // else a box around a node wouldn't be seen
  });

  const Drawing drawing{chart.width, chart.height, [&](cairo_t* cairo) { draw_chart(cairo, chart, cells); }};
  if (!is_svg) return write_png(drawing, path, {{"Software", fmt::format("Masu {} {}", version, commit)}});
  // What the labels say, too: they are outlines of letters.
  const std::string legend =
      fmt::format("{}. Right: {}. Up: {}. Colour: {}", subtitle, axis_name(0), axis_name(1), range.label()) +
      (range.has_values() ? fmt::format(", {:.3g} to {:.3g}", range.low, range.high) : "") +
      (range.has_empty ? "; white: " + chart.white : "");
  write_svg(drawing, path, title,
            fmt::format("{}. Masu {} {}: {}", legend, version, commit, fmt::join(command_line(), " ")));
}

} // namespace masu
