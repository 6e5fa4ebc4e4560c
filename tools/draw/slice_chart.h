// What a picture of a slice has around its cells: axes, a legend, the outline of the geometry, titles.
#pragma once

#include "libgrid/statistics/slice.h"
#include "libscene/plane_cut.h"
#include "tools/draw/drawing.h"
#include "tools/draw/slice_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace masu {

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
inline Rgb shade_of(const ColorMap& map, double darkness) {
  return map(1 - darkness);
}

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

// The places of everything, in a page whose plot has `size` pixels along its longer side.
void lay_out(Chart& chart, const SliceWindow& window, std::int32_t size, const std::string& title,
             const std::string& subtitle);

// Draws all of it on the cells, whose colours the map has.
void draw_around(cairo_t* cairo, const Chart& chart, const ColorMap& map);

} // namespace masu
