// Pages that Cairo draws: a chart is one function over its context, and written as PNG or SVG.
#pragma once

#include "renderer/image/png_file.h"
#include "tools/common/color_map.h"

#include <cairo.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace masu {

// A white page of width × height pixels. Coordinates are pixels from its upper left corner. draw() is called
// for each part of a page, clipped to it, and may use the functions below and Cairo's own; whether Cairo
// failed is found out afterwards.
struct Drawing {
  std::int32_t width, height;
  std::function<void(cairo_t*)> draw;
};

// Both throw Error(output, path, …). Where no font is found, a line on standard error says so, and there is
// no text. The same page has the same bytes on a machine; text depends on its fonts.
void write_png(const Drawing& drawing, const std::string& path, const PictureTexts& texts);
// `title` and `description` may hold any bytes.
void write_svg(const Drawing& drawing, const std::string& path, const std::string& title,
               const std::string& description);

inline constexpr Rgb black{0, 0, 0}, white{255, 255, 255};

struct DrawingBox {
  double left, top, right, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

void set_color(cairo_t* cairo, Rgb color, double opacity = 1);
void fill_box(cairo_t* cairo, const DrawingBox& box, Rgb color);
// Around the box, outside of it.
void draw_frame(cairo_t* cairo, const DrawingBox& box, double width, Rgb color = black);

// Each pixel as a square of `side` pixels of the page, of exactly that colour; rows from the top, `columns`
// pixels each. left, top: whole numbers.
void draw_pixels(cairo_t* cairo, std::int32_t left, std::int32_t top, std::int32_t side, std::int32_t columns,
                 std::span<const Rgb> colors);

// --- Text -------------------------------------------------------------------------------------------------

inline constexpr double capital_height = 0.73, line_height = 1.4; // of a font's size

// Which point of a text, on its baseline, its position is; and whether it runs to the right or upwards.
enum class TextAnchor { start, middle, end };
enum class TextDirection { right, up };

// Text of any bytes: those that aren't UTF-8 and control characters appear as \xNN.
void draw_text(cairo_t* cairo, double x, double y, const std::string& text, double size,
               TextAnchor anchor = TextAnchor::start, TextDirection direction = TextDirection::right);

// In pixels, as draw_text() draws it; 0 without fonts. Throws as write_png() does.
double text_width(const std::string& text, double size);

// Lines of whole words that fit `width`; the font is smaller than `size` where a word is wider.
struct TextBlock {
  std::vector<std::string> lines;
  double size;

  double height() const { return static_cast<double>(lines.size()) * line_height * size; }
};
TextBlock text_block(const std::string& text, double size, double width);
// `top`: of the first line.
void draw_text_block(cairo_t* cairo, double left, double top, const TextBlock& block);

// --- Ticks and colour bars --------------------------------------------------------------------------------

// Multiples of 1, 2 or 5 times a power of ten from low to high, at most `most` (2 or more) of them; whole
// numbers alone on request.
std::vector<double> linear_ticks(double low, double high, int most, bool whole = false);

// From values to 0 … 1.
struct ColorScale {
  double low = 0, high = 1;
  bool logarithmic = false;
  double offset = 0;  // added before the logarithm: 1 for counts, which may be 0
  bool whole = false; // of whole numbers alone

  double share(double value) const;
};

struct ColorBarLabel {
  double share; // of the bar's height from below, 0 to 1
  std::string text;
};
// Both ends, and round numbers between them that have room on a bar of that height.
std::vector<ColorBarLabel> color_bar_labels(const ColorScale& scale, double height, double text_size);

// color(0) below to color(1) above, with a tick for each label at the right. Labels reach half a line beyond
// the ends.
void draw_color_bar(cairo_t* cairo, const DrawingBox& box, const std::function<Rgb(double)>& color,
                    std::span<const ColorBarLabel> labels, double text_size);
// How far that reaches beyond the bar's right side.
double color_bar_label_width(std::span<const ColorBarLabel> labels, double text_size);

} // namespace masu
