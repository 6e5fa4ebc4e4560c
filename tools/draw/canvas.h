// Two canvases with the same functions, to draw a chart once for either: pixels, and SVG. Coordinates are
// pixels from the upper left corner of the canvas; a chart is a function template over the canvas.
#pragma once

#include "tools/draw/bitmap_text.h"

#include <array>
#include <map>
#include <span>
#include <string>

namespace masu {

struct CanvasPoint {
  double x, y;
};
struct CanvasLine {
  CanvasPoint from, to;
};
struct CanvasBox {
  double left, top, right, bottom;
};

// Which point of a text its position is.
enum class TextAnchor { start, middle, end };

// A text's capital letters are text_height · scale high, upwards from the baseline at its position; with
// TextDirection::up the baseline is vertical and ends of lines are above their starts.
struct CanvasText {
  CanvasPoint at;
  std::string text;
  TextAnchor anchor = TextAnchor::start;
  TextDirection direction = TextDirection::right;
  std::int32_t scale = 1;
};

class PngCanvas {
public:
  PngCanvas(std::int32_t width, std::int32_t height) : picture(width, height) {}

  void box(const CanvasBox& box, Rgb color);
  // Antialiased; what lies outside `clip` is left out. `opacity` from 0 to 1.
  void lines(std::span<const CanvasLine> lines, Rgb color, double width, double opacity,
             const CanvasBox& clip);
  void text(const CanvasText& text, Rgb color);
  // Boxes of one or a few colours, as the cells of a slice are; like box().
  void cell(const CanvasBox& box, Rgb color) { this->box(box, color); }

  Picture picture;
};

class SvgCanvas {
public:
  SvgCanvas(std::int32_t width, std::int32_t height) : width_(width), height_(height) {}

  void box(const CanvasBox& box, Rgb color);
  void lines(std::span<const CanvasLine> lines, Rgb color, double width, double opacity,
             const CanvasBox& clip);
  void text(const CanvasText& text, Rgb color);
  // Cells of a colour become one path.
  void cell(const CanvasBox& box, Rgb color);
  // To be called after the last cell and before what is drawn over them.
  void finish_cells();

  // The whole file. `description`: for its metadata.
  std::string document(const std::string& title, const std::string& description) const;

private:
  std::int32_t width_, height_;
  std::string body_;
  std::map<std::uint32_t, std::string> cells_; // path data by colour
  int clips_ = 0;
};

} // namespace masu
