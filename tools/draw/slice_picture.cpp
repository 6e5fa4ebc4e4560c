#include "tools/draw/slice_picture.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"
#include "renderer/image/png_file.h"
#include "tools/common/json.h"
#include "tools/common/print.h"
#include "tools/common/version.h"
#include "tools/draw/slice_chart.h"
#include "tools/report/slice_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace masu {
namespace {

constexpr std::size_t most_svg_cells = std::size_t{1} << 18;

// --- Cells -----------------------------------------------------------------------------------------------

// A cell's part in the plot.
DrawingBox box_of(const Plot& plot, const GridLayout& finest, int axis, const SliceCell& cell) {
  const SliceWindow scene = in_scene(finest, axis, cell);
  const DrawingBox& in = plot.box;
  return {std::clamp(plot.x(scene.min[0]), in.left, in.right),
          std::clamp(plot.y(scene.max[1]), in.top, in.bottom),
          std::clamp(plot.x(scene.max[0]), in.left, in.right),
          std::clamp(plot.y(scene.min[1]), in.top, in.bottom)};
}

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
    const bool is_light = 2 * color[0] + 5 * color[1] + color[2] > 8 * 110;
    if (darkness) cells_[std::lround(*darkness * most_shade)].push_back(box);
    if (with_lines && box.width() >= room_for_lines && box.height() >= room_for_lines)
      (is_light ? with_dark_lines_ : with_light_lines_).push_back(box);
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

// --- Texts -----------------------------------------------------------------------------------------------

std::string title_of(const StructureFile& file, const SlicePlane& plane, const GridLayout& finest) {
  const std::string title =
      fmt::format("{}, {} = {:.5g}", std::filesystem::path(file.path()).filename().string(),
                  "xyz"[plane.axis], plane.position);
  return file.is_hierarchy()
             ? title
             : fmt::format("{} (layer {} of {})", title, plane.layer, finest.division[plane.axis]);
}

const char* kind_of(fb::Merge merge) {
  return merge == fb::Merge::none      ? "uniform grid"
         : merge == fb::Merge::x       ? "grid merged along x"
         : merge == fb::Merge::balance ? "grid merged by balance"
                                       : "irregular grid";
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
  const bool is_hierarchy = file.is_hierarchy();
  if (style.high > 0 && style.color == SliceColor::volume)
    throw Error(ErrorCode::usage, "--color-high",
                "is of references or depth: volumes have a logarithmic scale");
  if (is_hierarchy && style.color == SliceColor::volume)
    throw Error(ErrorCode::usage, "--color", "volume needs a grid of cells: a hierarchy has none");
  // None of cells that list nothing, coloured by references. Volumes are in voxels of the division.
  const auto value = [&, nested_log2 = static_cast<int>(file.table().nested_log2())](
                         const SliceCell& cell) -> std::optional<double> {
    if (style.color == SliceColor::volume)
      return std::ldexp(static_cast<double>(cell.voxels), -3 * nested_log2);
    if (style.color == SliceColor::depth) return cell.depth;
    return cell.references == 0 ? std::nullopt : std::optional<double>(cell.references);
  };
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

  const Drawing drawing{chart.width, chart.height, [&](cairo_t* cairo) {
                          cells.draw(cairo, chart.plot.line());
                          draw_around(cairo, chart, cells.map());
                        }};
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
