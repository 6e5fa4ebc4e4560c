#include "tools/draw/drawing.h"

#include "libscene/base/error.h"
#include "libscene/base/printable.h"
#include "libscene/file/output_file.h"
#include "tools/common/print.h"

#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <numbers>
#include <utility>

namespace masu {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

void check(cairo_status_t status, const std::string& place) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorCode::output, place, fmt::format("can't be drawn: {}", cairo_status_to_string(status)));
}

// Glyphs have the same positions at any resolution, and no coloured fringes, whatever the desktop's settings.
Owned<cairo_t> context_of(cairo_surface_t* surface, const std::string& place) {
  Owned<cairo_t> cairo(cairo_create(surface));
  const Owned<cairo_font_options_t> options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo.get(), options.get());
  cairo_select_font_face(cairo.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  check(cairo_status(cairo.get()), place);
  return cairo;
}

// Where Fontconfig knows no font, Cairo takes one of its own, which has capital letters alone.
bool has_font(cairo_t* cairo) {
  return cairo_scaled_font_get_type(cairo_get_scaled_font(cairo)) != CAIRO_FONT_TYPE_USER;
}

void draw_page(cairo_surface_t* surface, const Drawing& drawing, std::int32_t left, std::int32_t top,
               const std::string& path) {
  const Owned<cairo_t> cairo = context_of(surface, path);
  if (left == 0 && top == 0 && !has_font(cairo.get()))
    print_note("{}: {}: warning: has no text: no font was found (install fonts-dejavu-core)\n",
               program_invocation_short_name, printable(path));
  set_color(cairo.get(), white);
  cairo_paint(cairo.get());
  cairo_translate(cairo.get(), -left, -top);
  drawing.draw(cairo.get());
  check(cairo_status(cairo.get()), path);
}

std::string xml_text(const std::string& text) {
  std::string xml;
  for (const char c : printable(text)) {
    xml += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return xml;
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  try {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) { // which mustn't pass through Cairo
    return CAIRO_STATUS_NO_MEMORY;
  }
}

double advance_of(cairo_t* cairo, const std::string& text, double size) {
  cairo_text_extents_t extents{};
  cairo_set_font_size(cairo, size);
  cairo_text_extents(cairo, printable(text).c_str(), &extents);
  return extents.x_advance;
}

} // namespace

void write_png(const Drawing& drawing, const std::string& path, const PictureTexts& texts) {
  constexpr std::int32_t side = 8192; // of a part: Cairo's images have at most 32767 pixels a side
  const auto [width, height] = std::pair(drawing.width, drawing.height);
  std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::int32_t top = 0; top < height; top += side) {
    for (std::int32_t left = 0; left < width; left += side) {
      const std::int32_t columns = std::min(side, width - left), rows = std::min(side, height - top);
      const Owned<cairo_surface_t> part(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
      draw_page(part.get(), drawing, left, top, path);
      cairo_surface_flush(part.get());
      for (std::int32_t y = 0; y < rows; ++y) {
        const unsigned char* from =
            cairo_image_surface_get_data(part.get()) +
            static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(part.get());
        std::uint8_t* to = &rgb[3 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(left))];
        for (std::int32_t x = 0; x < columns; ++x, from += 4, to += 3) {
          std::uint32_t pixel = 0; // 0x00RRGGBB
          std::memcpy(&pixel, from, sizeof pixel);
          to[0] = static_cast<std::uint8_t>(pixel >> 16);
          to[1] = static_cast<std::uint8_t>(pixel >> 8);
          to[2] = static_cast<std::uint8_t>(pixel);
        }
      }
    }
  }
  write_png(rgb, width, height, path, texts);
}

void write_svg(const Drawing& drawing, const std::string& path, const std::string& title,
               const std::string& description) {
  std::string svg;
  {
    const Owned<cairo_surface_t> surface(
        cairo_svg_surface_create_for_stream(append, &svg, drawing.width, drawing.height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_USER);
    draw_page(surface.get(), drawing, 0, 0, path);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()), path);
  }
  // Cairo has no function for these; nor, in 1.16, for filled boxes that meet without a seam at any scale.
  svg.insert(
      svg.find('>', svg.find("<svg")) + 1,
      fmt::format("\n<title>{}</title>\n<desc>{}</desc>\n"
                  "<style>path[fill-rule],path[style*=fill-rule]{{shape-rendering:crispEdges}}</style>",
                  xml_text(title), xml_text(description)));
  write_text_file(path, svg);
}

void set_color(cairo_t* cairo, Rgb color, double opacity) {
  cairo_set_source_rgba(cairo, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0, opacity);
}

void fill_box(cairo_t* cairo, const DrawingBox& box, Rgb color) {
  set_color(cairo, color);
  cairo_rectangle(cairo, box.left, box.top, box.width(), box.height());
  cairo_fill(cairo);
}

void draw_frame(cairo_t* cairo, const DrawingBox& box, double width, Rgb color) {
  set_color(cairo, color);
  cairo_set_line_width(cairo, width);
  cairo_rectangle(cairo, box.left - width / 2, box.top - width / 2, box.width() + width,
                  box.height() + width);
  cairo_stroke(cairo);
}

void draw_pixels(cairo_t* cairo, std::int32_t left, std::int32_t top, std::int32_t side, std::int32_t columns,
                 std::span<const Rgb> colors) {
  const auto rows = static_cast<std::int32_t>(colors.size() / static_cast<std::size_t>(columns));
  cairo_save(cairo);
  cairo_rectangle(cairo, left, top, columns * side, rows * side);
  cairo_clip(cairo);
  // Those that are seen, as the source of a copy: its size has Cairo's limit, too.
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  cairo_clip_extents(cairo, &x0, &y0, &x1, &y1); // whole numbers
  const auto first_x = static_cast<std::int32_t>(x0), end_x = static_cast<std::int32_t>(x1),
             first_y = static_cast<std::int32_t>(y0), end_y = static_cast<std::int32_t>(y1);
  const Owned<cairo_surface_t> image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, end_x - first_x, end_y - first_y));
  unsigned char* const data = cairo_image_surface_get_data(image.get());
  for (std::int32_t y = first_y; data != nullptr && y < end_y; ++y) {
    unsigned char* to =
        data + static_cast<std::ptrdiff_t>(y - first_y) * cairo_image_surface_get_stride(image.get());
    const auto row =
        colors.subspan(static_cast<std::size_t>((y - top) / side) * static_cast<std::size_t>(columns));
    for (std::int32_t x = first_x; x < end_x; ++x, to += 4) {
      const Rgb color = row[static_cast<std::size_t>((x - left) / side)];
      const std::uint32_t pixel = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 | color[2];
      std::memcpy(to, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(image.get());
  cairo_set_source_surface(cairo, image.get(), first_x,
                           first_y); // which takes over the image's error, if any
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
}

void draw_text(cairo_t* cairo, double x, double y, const std::string& text, double size, TextAnchor anchor,
               TextDirection direction) {
  if (!has_font(cairo)) return;
  cairo_save(cairo);
  set_color(cairo, black);
  cairo_translate(cairo, x, y);
  if (direction == TextDirection::up) cairo_rotate(cairo, -std::numbers::pi / 2);
  const double width = advance_of(cairo, text, size);
  cairo_move_to(cairo, anchor == TextAnchor::start ? 0 : anchor == TextAnchor::end ? -width : -width / 2, 0);
  cairo_show_text(cairo, printable(text).c_str());
  cairo_restore(cairo);
}

double text_width(const std::string& text, double size) {
  const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Owned<cairo_t> cairo = context_of(surface.get(), "text");
  const double width = has_font(cairo.get()) ? advance_of(cairo.get(), text, size) : 0;
  check(cairo_status(cairo.get()), "text");
  return width;
}

TextBlock text_block(const std::string& text, double size, double width) {
  TextBlock block{{}, size};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t space = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, space - at);
    at = space + 1;
    if (block.lines.empty() || text_width(block.lines.back() + ' ' + word, size) > width)
      block.lines.push_back(word);
    else
      block.lines.back() += ' ' + word;
  }
  for (const std::string& line : block.lines)
    block.size = std::min(block.size, size * width / std::max(text_width(line, size), 1.0));
  return block;
}

void draw_text_block(cairo_t* cairo, double left, double top, const TextBlock& block) {
  for (const std::string& line : block.lines) {
    draw_text(cairo, left, top + block.size, line, block.size);
    top += line_height * block.size;
  }
}

namespace {
// Of a colour bar's ticks and the space before their labels, of the font's size.
constexpr double tick_length = 0.3, tick_gap = 0.25;

// Of a logarithmic axis, 0 < low ≤ high: 1, 2 and 5 times powers of ten, or powers alone where these are more
// than `most`.
std::vector<double> logarithmic_ticks(double low, double high, std::size_t most) {
  std::vector<double> all, powers;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  for (int exponent = first; exponent <= last; ++exponent) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double tick = digit * std::pow(10, exponent);
      if (tick < low * (1 - 1e-9) || tick > high * (1 + 1e-9)) continue;
      all.push_back(tick);
      if (digit == 1) powers.push_back(tick);
    }
  }
  if (all.size() <= most) return all;
  const std::size_t share = (powers.size() + most - 1) / std::max<std::size_t>(most, 1);
  std::vector<double> some;
  for (std::size_t i = 0; i < powers.size(); i += std::max<std::size_t>(share, 1))
    some.push_back(powers[i]);
  return some;
}

} // namespace

std::vector<double> linear_ticks(double low, double high, int most, bool whole) {
  std::vector<double> ticks;
  if (!(high > low) || !std::isfinite(high - low)) return ticks;
  double power = std::pow(10, std::floor(std::log10((high - low) / most)));
  if (whole) power = std::max(power, 1.0);
  for (const double digit : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const double step = digit * power, slack = step * 1e-9;
    const double first = std::ceil((low - slack) / step), last = std::floor((high + slack) / step);
    if (last - first + 1 > most) continue;
    const int count = static_cast<int>(last - first);
    for (int i = 0; i <= count; ++i)
      ticks.push_back((first + i) * step + 0.0); // never -0
    return ticks;
  }
  return ticks;
}

double ColorScale::share(double value) const {
  if (!(high > low)) return 0;
  if (!logarithmic) return (value - low) / (high - low);
  return std::log((value + offset) / (low + offset)) / std::log((high + offset) / (low + offset));
}

std::vector<ColorBarLabel> color_bar_labels(const ColorScale& scale, double height, double text_size) {
  const double room = 1.3 * text_size / height;
  std::vector<ColorBarLabel> labels;
  const auto add = [&](double value) {
    const double share = scale.share(value);
    for (const ColorBarLabel& other : labels)
      if (std::abs(share - other.share) < room) return;
    const bool is_whole = value == std::floor(value) && std::abs(value) < 1e6;
    labels.push_back({share, is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value)});
  };
  add(scale.low);
  add(scale.high);
  const int most = std::clamp(static_cast<int>(0.9 / room), 2, 8);
  for (const double tick : scale.logarithmic ? logarithmic_ticks(scale.low > 0 ? scale.low : scale.offset,
                                                                 scale.high, static_cast<std::size_t>(most))
                                             : linear_ticks(scale.low, scale.high, most, scale.whole))
    add(tick);
  return labels;
}

void draw_color_bar(cairo_t* cairo, const DrawingBox& box, const std::function<Rgb(double)>& color,
                    std::span<const ColorBarLabel> labels, double text_size) {
  constexpr int stops = 64; // between which Cairo interpolates
  const Owned<cairo_pattern_t> gradient(cairo_pattern_create_linear(0, box.bottom, 0, box.top));
  for (int i = 0; i <= stops; ++i) {
    const double share = static_cast<double>(i) / stops;
    const Rgb at = color(share);
    cairo_pattern_add_color_stop_rgb(gradient.get(), share, at[0] / 255.0, at[1] / 255.0, at[2] / 255.0);
  }
  cairo_set_source(cairo, gradient.get());
  cairo_rectangle(cairo, box.left, box.top, box.width(), box.height());
  cairo_fill(cairo);
  const double line = std::max(1.0, std::round(text_size / 16)), height = capital_height * text_size;
  draw_frame(cairo, box, line);
  for (const ColorBarLabel& label : labels) {
    const double y = std::round(box.bottom - label.share * box.height() - line / 2);
    fill_box(cairo, {box.right, y, box.right + tick_length * text_size, y + line}, black);
    draw_text(cairo, box.right + (tick_length + tick_gap) * text_size, y + (line + height) / 2, label.text,
              text_size);
  }
}

double color_bar_label_width(std::span<const ColorBarLabel> labels, double text_size) {
  double widest = 0;
  for (const ColorBarLabel& label : labels)
    widest = std::max(widest, text_width(label.text, text_size));
  return (tick_length + tick_gap) * text_size + widest;
}

} // namespace masu
