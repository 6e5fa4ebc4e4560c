#include "tools/draw/slice_picture.h"

#include "libscene/base/error.h"
#include "renderer/image/png_file.h"
#include "tools/common/printable.h"
#include "tools/common/provenance.h"
#include "tools/draw/axis_ticks.h"
#include "tools/draw/canvas.h"
#include "tools/report/slice_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

namespace masu {
namespace {

constexpr Rgb black{0, 0, 0}, white{255, 255, 255}, outline_color{214, 40, 20};
constexpr std::size_t most_svg_cells = std::size_t{1} << 18, most_json_cells = std::size_t{1} << 22;

// --- Values and their colours ----------------------------------------------------------------------------

// A cell's value; none for empty cells coloured by references. Volumes are in voxels of the division.
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

// From the least to the greatest value of the cells shown.
struct ValueScale {
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
  bool is_logarithmic() const {
    return color == SliceColor::volume || (color == SliceColor::references && high > 16);
  }
  // From 0 (the least) to 1 (the greatest).
  double share(double value) const {
    if (!(high > low)) return 0.5;
    return is_logarithmic() ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  }
  // How dark: few references, large and undivided cells are light.
  double darkness(double value) const {
    if (!(high > low)) return 0.25;
    return color == SliceColor::volume ? 1 - share(value) : share(value);
  }
  const char* label() const {
    return color == SliceColor::references ? "references"
           : color == SliceColor::volume   ? "cell volume (voxels)"
                                           : "depth of nesting";
  }
  // Both ends, and round numbers between them that leave room for the ends' labels.
  std::vector<double> ticks(double length, double label_height) const {
    if (!(high > low)) return {low};
    const int most = std::clamp(static_cast<int>(length / (1.7 * label_height)), 2, 8);
    std::vector<double> ticks{low};
    for (const double tick : is_logarithmic() ? logarithmic_ticks(low, high, static_cast<std::size_t>(most))
                                              : linear_ticks(low, high, most, true)) {
      const double room = 1.6 * label_height / length;
      if (share(tick) > room && share(tick) < 1 - room) ticks.push_back(tick);
    }
    ticks.push_back(high);
    return ticks;
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

// Scene units to pixels. Both axes have the same scale unless the plot would be too flat for its labels.
struct Plot {
  CanvasBox box;
  SliceWindow window;
  std::int32_t text_scale;

  double x(double u) const {
    return box.left + (u - window.min[0]) / (window.max[0] - window.min[0]) * (box.right - box.left);
  }
  double y(double v) const {
    return box.bottom - (v - window.min[1]) / (window.max[1] - window.min[1]) * (box.bottom - box.top);
  }
  CanvasPoint point(const std::array<double, 2>& at) const { return {x(at[0]), y(at[1])}; }
  double width() const { return box.right - box.left; }
  double height() const { return box.bottom - box.top; }
};

// In pixels at text scale 1: room for the title, the axes' numbers and names, the legend.
constexpr double top_margin = 34, bottom_margin = 34, left_margin = 66, right_margin = 92;

Plot plot_of(const SliceWindow& window, std::int32_t size) {
  const std::int32_t scale = std::max(1, (size + 160) / 320);
  const double u = window.max[0] - window.min[0], v = window.max[1] - window.min[1], longer = std::max(u, v);
  const double shortest = std::min<double>(60 * scale, size);
  const double width = std::max(std::round(size * (u / longer)), shortest),
               height = std::max(std::round(size * (v / longer)), shortest);
  const double left = left_margin * scale, top = top_margin * scale;
  return {{left, top, left + width, top + height}, window, scale};
}

std::int32_t canvas_width(const Plot& plot) {
  return static_cast<std::int32_t>(plot.box.right + right_margin * plot.text_scale);
}
std::int32_t canvas_height(const Plot& plot) {
  return static_cast<std::int32_t>(plot.box.bottom + bottom_margin * plot.text_scale);
}

// A cell's part in the plot.
CanvasBox box_of(const Plot& plot, const GridLayout& finest, int axis, const SliceCell& cell) {
  VoxelBox voxels{};
  const std::array<int, 2> axes = slice_axes(axis);
  for (std::size_t i = 0; i < 2; ++i) {
    voxels.first.set(axes[i], cell.first[i]);
    voxels.end.set(axes[i], cell.end[i]);
  }
  const Boxd box = box_in_scene(finest, voxels);
  const auto clamped = [](double at, double low, double high) { return std::clamp(at, low, high); };
  const CanvasBox& in = plot.box;
  return {clamped(plot.x(box.min[axes[0]]), in.left, in.right),
          clamped(plot.y(box.max[axes[1]]), in.top, in.bottom),
          clamped(plot.x(box.max[axes[0]]), in.left, in.right),
          clamped(plot.y(box.min[axes[1]]), in.top, in.bottom)};
}

// --- Cells -----------------------------------------------------------------------------------------------

// Lines on the left and lower side, which neighbours share; none where they would leave hardly anything.
constexpr double room_for_lines = 4;

// Cells as pixels of the plot: a pixel shows the darkest of the cells that it touches.
class CellRaster {
public:
  explicit CellRaster(const Plot& plot)
      : left_(static_cast<std::int32_t>(plot.box.left)), top_(static_cast<std::int32_t>(plot.box.top)),
        columns_(static_cast<std::int32_t>(plot.width())), rows_(static_cast<std::int32_t>(plot.height())),
        darkness_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), -1),
        line_(darkness_.size(), false) {}

  void add(const CanvasBox& box, std::optional<double> darkness, bool with_lines) {
    const std::int32_t left = edge(box.left - left_, columns_), top = edge(box.top - top_, rows_);
    const std::int32_t right = std::max(edge(box.right - left_, columns_), std::min(left + 1, columns_)),
                       bottom = std::max(edge(box.bottom - top_, rows_), std::min(top + 1, rows_));
    for (std::int32_t y = top; darkness && y < bottom; ++y) {
      for (std::int32_t x = left; x < right; ++x)
        darkness_[index(x, y)] = std::max(darkness_[index(x, y)], static_cast<float>(*darkness));
    }
    if (with_lines && right - left >= room_for_lines && bottom - top >= room_for_lines) {
      for (std::int32_t y = top; y < bottom; ++y)
        line_[index(left, y)] = true;
      for (std::int32_t x = left; x < right; ++x)
        line_[index(x, bottom - 1)] = true;
    }
  }

  void draw(Picture& picture, const ColorMap& map, std::int32_t line_width) const {
    for (std::int32_t y = 0; y < rows_; ++y) {
      for (std::int32_t x = 0; x < columns_; ++x)
        picture.fill(left_ + x, top_ + y, 1, 1, color_at_pixel(map, x, y));
    }
    for (std::int32_t y = 0; y < rows_; ++y) {
      for (std::int32_t x = 0; x < columns_; ++x) {
        if (!line_[index(x, y)]) continue;
        const Rgb color = color_at_pixel(map, x, y);
        for (std::int32_t i = 0; i < line_width; ++i)
          picture.blend(left_ + x, top_ + y - i, is_light(color) ? black : white, 0.4);
      }
    }
  }

private:
  static std::int32_t edge(double at, std::int32_t end) {
    return std::clamp(static_cast<std::int32_t>(std::lround(at)), 0, end);
  }
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  Rgb color_at_pixel(const ColorMap& map, std::int32_t x, std::int32_t y) const {
    const float darkness = darkness_[index(x, y)];
    return darkness < 0 ? white : shade_of(map, static_cast<double>(darkness));
  }

  std::int32_t left_, top_, columns_, rows_;
  std::vector<float> darkness_; // -1: empty
  std::vector<bool> line_;
};

// What is drawn, whatever the canvas.
struct Chart {
  Plot plot;
  ValueScale scale;
  const ColorMap& map;
  std::string title, subtitle;
  std::array<char, 2> axis_names;
  std::span<const SectionSegment> outline;
};

// --- Axes, legend and outline ----------------------------------------------------------------------------

// Text that fits so many pixels.
std::string cut_to(const std::string& text, double pixels, std::int32_t scale) {
  const auto most = static_cast<std::size_t>(std::max(pixels / (text_advance * scale), 4.0));
  return text.size() <= most ? text : text.substr(0, most - 3) + "...";
}

template <class Canvas>
void draw_frame(Canvas& canvas, const CanvasBox& box, double width) {
  canvas.box({box.left - width, box.top - width, box.right + width, box.top}, black);
  canvas.box({box.left - width, box.bottom, box.right + width, box.bottom + width}, black);
  canvas.box({box.left - width, box.top, box.left, box.bottom}, black);
  canvas.box({box.right, box.top, box.right + width, box.bottom}, black);
}

template <class Canvas>
void draw_axes(Canvas& canvas, const Chart& chart) {
  const Plot& plot = chart.plot;
  const std::int32_t s = plot.text_scale;
  const double tick = 3.0 * s, line = std::max(1, s / 2), gap = 3.0 * s;
  const auto most = [&](double length, double label) {
    return std::clamp(static_cast<int>(length / label), 2, 9);
  };
  const int columns = most(plot.width(), 40.0 * s), rows = most(plot.height(), 20.0 * s);
  for (const double at : linear_ticks(plot.window.min[0], plot.window.max[0], columns)) {
    const double x = std::round(plot.x(at)), y = plot.box.bottom;
    canvas.box({x, y, x + line, y + tick}, black);
    canvas.text(
        {{x, y + tick + gap + text_height * s}, tick_text(at), TextAnchor::middle, TextDirection::right, s},
        black);
  }
  std::size_t longest = 0;
  for (const double at : linear_ticks(plot.window.min[1], plot.window.max[1], rows)) {
    const double x = plot.box.left, y = std::round(plot.y(at));
    canvas.box({x - tick, y, x, y + line}, black);
    canvas.text({{x - tick - gap, y + text_height * s / 2.0},
                 tick_text(at),
                 TextAnchor::end,
                 TextDirection::right,
                 s},
                black);
    longest = std::max(longest, tick_text(at).size());
  }
  const double middle_x = (plot.box.left + plot.box.right) / 2,
               middle_y = (plot.box.top + plot.box.bottom) / 2;
  canvas.text({{middle_x, plot.box.bottom + tick + 2 * gap + 2.0 * text_height * s + 2.0 * s},
               fmt::format("{} (scene units)", chart.axis_names[0]),
               TextAnchor::middle,
               TextDirection::right,
               s},
              black);
  const double numbers = static_cast<double>(longest) * text_advance * s;
  canvas.text({{std::max(plot.box.left - tick - 2.5 * gap - numbers, 9.0 * s), middle_y},
               fmt::format("{} (scene units)", chart.axis_names[1]),
               TextAnchor::middle,
               TextDirection::up,
               s},
              black);
}

template <class Canvas>
void draw_legend(Canvas& canvas, const Chart& chart) {
  const std::int32_t s = chart.plot.text_scale;
  const CanvasBox& plot = chart.plot.box;
  const double left = plot.right + 12.0 * s, right = left + 12.0 * s, tick = 3.0 * s;
  const double line = std::max(1, s / 2), height = text_height * s;
  double bottom = plot.bottom;
  if (chart.scale.has_empty) {
    const CanvasBox patch{left, bottom - height - 2.0 * s, right, bottom};
    canvas.box(patch, white);
    draw_frame(canvas, patch, line);
    canvas.text(
        {{right + tick + 2.0 * s, bottom - 1.0 * s}, "empty", TextAnchor::start, TextDirection::right, s},
        black);
    bottom = patch.top - 8.0 * s;
  }
  if (!chart.scale.has_values()) return;
  const CanvasBox bar{left, plot.top, right, bottom};
  const double length = bar.bottom - bar.top;
  const auto steps = static_cast<int>(chart.scale.high > chart.scale.low ? std::min(length, 256.0) : 1);
  for (int i = 0; i < steps; ++i) {
    const double share = steps > 1 ? i / (steps - 1.0) : 0.5;
    const double darkness = steps == 1 ? 0.25 : chart.scale.color == SliceColor::volume ? 1 - share : share;
    canvas.box({bar.left, bar.bottom - length * (i + 1) / steps, bar.right, bar.bottom - length * i / steps},
               shade_of(chart.map, darkness));
  }
  draw_frame(canvas, bar, line);
  std::size_t longest = 0;
  for (const double at : chart.scale.ticks(length, height)) {
    const double y = std::round(bar.bottom - chart.scale.share(at) * length);
    const std::string text = fmt::format("{:.3g}", at);
    const std::string whole = at == std::floor(at) && at < 1e6 ? fmt::format("{:.0f}", at) : text;
    canvas.box({right, y, right + tick, y + line}, black);
    canvas.text({{right + tick + 2.0 * s,
                  std::clamp(y + height / 2, bar.top + height - 3.0 * s, bar.bottom + 3.0 * s)},
                 whole,
                 TextAnchor::start,
                 TextDirection::right,
                 s},
                black);
    longest = std::max(longest, whole.size());
  }
  const double numbers = static_cast<double>(std::max<std::size_t>(longest, 2)) * text_advance * s;
  canvas.text({{right + tick + 6.0 * s + numbers + height, (bar.top + bar.bottom) / 2},
               chart.scale.label(),
               TextAnchor::middle,
               TextDirection::up,
               s},
              black);
}

template <class Canvas>
void draw_outline(Canvas& canvas, const Chart& chart) {
  std::vector<CanvasLine> lines;
  lines.reserve(chart.outline.size());
  for (const SectionSegment& segment : chart.outline)
    lines.push_back({chart.plot.point(segment.from), chart.plot.point(segment.to)});
  const double width = 0.7 * chart.plot.text_scale;
  canvas.lines(lines, white, 2 * width, 0.6, chart.plot.box); // readable on dark cells, and without colour
  canvas.lines(lines, outline_color, width, 1, chart.plot.box);
}

// All but the cells, over them.
template <class Canvas>
void draw_chart(Canvas& canvas, const Chart& chart) {
  const Plot& plot = chart.plot;
  const std::int32_t s = plot.text_scale;
  draw_outline(canvas, chart);
  draw_frame(canvas, plot.box, std::max(1, s / 2));
  draw_axes(canvas, chart);
  draw_legend(canvas, chart);
  const double left = 6.0 * s, room = canvas_width(plot) - 2 * left;
  const auto line = [&](const std::string& text, double baseline) {
    canvas.text({{left, baseline}, cut_to(text, room, s), TextAnchor::start, TextDirection::right, s}, black);
  };
  line(chart.title, 12.0 * s);
  line(chart.subtitle, 24.0 * s);
}

std::string by_by(const Vec3i& n) {
  return fmt::format("{} x {} x {}", n.x, n.y, n.z);
}

std::string title_of(const GridFile& file, const SlicePlane& plane, const GridLayout& finest) {
  return fmt::format("{}, {} = {:.5g} (layer {} of {})",
                     std::filesystem::path(file.path()).filename().string(), "xyz"[plane.axis],
                     plane.position, plane.layer, finest.division[plane.axis]);
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

std::string subtitle_of(const GridFile& file, bool has_outline) {
  std::string text =
      fmt::format("{}, {} voxels", kind_of(file.table().merge()), by_by(file.layout().division));
  if (file.table().nested_log2() > 0) text += fmt::format(", nested 2^{}", file.table().nested_log2());
  return text + (has_outline ? "; red: geometry" : "");
}

void write_text(const std::string& text, const std::string& path) {
  OutputFile out(path);
  out.write(text.data(), text.size());
  out.commit();
}

} // namespace

void write_slice(const GridFile& file, const SlicePlane& plane, const SliceWindow& window,
                 std::span<const SectionSegment> outline, const SliceStyle& style, const std::string& path) {
  const bool is_svg = path.ends_with(".svg");
  if (path.ends_with(".json")) {
    auto json = slice_json(slice_of(file, plane, window, "--slice", most_json_cells), window, outline);
    json.update(program_version());
    return write_text(json_text(json, -1) + "\n", path);
  }
  const GridLayout finest = finest_layout(file);
  const auto nested_log2 = static_cast<std::int32_t>(file.table().nested_log2());
  const auto value = [&](const SliceCell& cell) { return value_of(cell, style.color, nested_log2); };
  ValueScale scale{style.color};
  std::size_t cells = 0;
  for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
    scale.include(value(cell));
    ++cells;
  });
  if (is_svg && cells > most_svg_cells)
    throw Error(ErrorCode::usage, path,
                fmt::format("an SVG of {} cells is too large: give a --window, or write a PNG", cells));

  const std::array<int, 2> axes = slice_axes(plane.axis);
  const ColorMap map;
  const Chart chart{plot_of(window, style.size),
                    scale,
                    map,
                    style.title.empty() ? title_of(file, plane, finest) : style.title,
                    subtitle_of(file, !outline.empty()),
                    {"xyz"[axes[0]], "xyz"[axes[1]]},
                    outline};
  const Plot& plot = chart.plot;
  const auto for_each_box = [&](const auto& act) { // act(box, how dark)
    for_each_slice_cell(file, plane, window, [&](const SliceCell& cell) {
      const std::optional<double> shown = value(cell);
      act(box_of(plot, finest, plane.axis, cell),
          shown ? std::optional(scale.darkness(*shown)) : std::nullopt);
    });
  };
  const std::string description =
      fmt::format("Masu {} {}: {}", version, commit, fmt::join(command_line(), " "));

  if (is_svg) {
    SvgCanvas canvas(canvas_width(plot), canvas_height(plot));
    std::vector<CanvasLine> on_light, on_dark;
    for_each_box([&](const CanvasBox& box, std::optional<double> darkness) {
      const Rgb color = darkness ? shade_of(map, *darkness) : white;
      if (darkness) canvas.cell(box, color);
      if (!style.lines || box.right - box.left < room_for_lines || box.bottom - box.top < room_for_lines)
        return;
      std::vector<CanvasLine>& lines = is_light(color) ? on_light : on_dark;
      lines.push_back({{box.left, box.top}, {box.left, box.bottom}});
      lines.push_back({{box.left, box.bottom}, {box.right, box.bottom}});
    });
    canvas.finish_cells();
    const double width = 0.5 * plot.text_scale;
    canvas.lines(on_light, black, width, 0.4, plot.box);
    canvas.lines(on_dark, white, width, 0.4, plot.box);
    draw_chart(canvas, chart);
    return write_text(canvas.document(chart.title, description), path);
  }
  PngCanvas canvas(canvas_width(plot), canvas_height(plot));
  CellRaster raster(plot);
  for_each_box(
      [&](const CanvasBox& box, std::optional<double> darkness) { raster.add(box, darkness, style.lines); });
  raster.draw(canvas.picture, map, std::max(1, plot.text_scale / 2));
  draw_chart(canvas, chart);
  const Picture& picture = canvas.picture;
  write_png(picture.rgb, picture.width, picture.height, path,
            {{"Software", fmt::format("Masu {} {}", version, commit)}});
}

} // namespace masu
