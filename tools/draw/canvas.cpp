#include "tools/draw/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace masu {
namespace {

std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(std::lround(std::clamp(value, -1e8, 1e8)));
}

// What XML can't hold: control characters, bytes that aren't UTF-8, surrogates, U+FFFE and U+FFFF become ?.
std::string xml_text(const std::string& text) {
  std::string xml;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t at) {
      return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    };
    const unsigned lead = byte(i);
    const std::size_t bytes = lead < 0x80       ? 1
                              : lead >> 5 == 6  ? 2
                              : lead >> 4 == 14 ? 3
                              : lead >> 3 == 30 ? 4
                                                : 0;
    std::uint32_t code = bytes == 1 ? lead : bytes == 0 ? 0 : lead & (0x7fU >> bytes);
    bool is_good = bytes > 0;
    for (std::size_t k = 1; k < bytes; ++k) {
      is_good = is_good && byte(i + k) >> 6 == 2;
      code = code << 6 | (byte(i + k) & 0x3f);
    }
    constexpr std::array<std::uint32_t, 5> least{0, 0x20, 0x80, 0x800, 0x10000};
    is_good = is_good && code >= least[bytes] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) &&
              code != 0x7f && code != 0xfffe && code != 0xffff;
    if (!is_good) {
      xml += '?';
      ++i;
      continue;
    }
    const std::string character = text.substr(i, bytes);
    xml += character == "&"    ? "&amp;"
           : character == "<"  ? "&lt;"
           : character == ">"  ? "&gt;"
           : character == "\"" ? "&quot;"
                               : character;
    i += bytes;
  }
  return xml;
}

std::string hex(Rgb color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

// To a hundredth of a pixel, as short as possible.
std::string short_number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

} // namespace

void PngCanvas::box(const CanvasBox& box, Rgb color) {
  const std::int32_t left = rounded(box.left), top = rounded(box.top);
  picture.fill(left, top, rounded(box.right) - left, rounded(box.bottom) - top, color);
}

// A pixel's share is what a line of this width covers of it, by the distance of its centre.
void PngCanvas::lines(std::span<const CanvasLine> lines, Rgb color, double width, double opacity,
                      const CanvasBox& clip) {
  const double reach = width / 2 + 0.5;
  for (const CanvasLine& line : lines) {
    const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y;
    const double square = dx * dx + dy * dy;
    // Row by row, or column by column where the line is steep: only pixels near it are visited.
    const bool is_steep = std::abs(dy) > std::abs(dx);
    const double slope = is_steep ? dx / dy : dx != 0 ? dy / dx : 0;
    const double spread = reach * std::sqrt(1 + slope * slope);
    const auto at = [&](double along) { // where the line's middle is across
      return is_steep ? line.from.x + (along - line.from.y) * slope
                      : line.from.y + (along - line.from.x) * slope;
    };
    const double first = is_steep ? std::min(line.from.y, line.to.y) : std::min(line.from.x, line.to.x);
    const double last = is_steep ? std::max(line.from.y, line.to.y) : std::max(line.from.x, line.to.x);
    const double clip_first = is_steep ? clip.top : clip.left,
                 clip_last = is_steep ? clip.bottom : clip.right;
    const double across_first = is_steep ? clip.left : clip.top,
                 across_last = is_steep ? clip.right : clip.bottom;
    const std::int32_t end = rounded(std::min(std::ceil(last + reach), clip_last));
    for (std::int32_t i = rounded(std::max(std::floor(first - reach), clip_first)); i < end; ++i) {
      const double middle = at(std::clamp(i + 0.5, first, last));
      const std::int32_t across_end = rounded(std::min(std::ceil(middle + spread + 1), across_last));
      for (std::int32_t k = rounded(std::max(std::floor(middle - spread - 1), across_first)); k < across_end;
           ++k) {
        const double x = (is_steep ? k : i) + 0.5 - line.from.x, y = (is_steep ? i : k) + 0.5 - line.from.y;
        const double t = square > 0 ? std::clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0;
        const double share = std::clamp(reach - std::hypot(x - t * dx, y - t * dy), 0.0, 1.0);
        if (share > 0) picture.blend(is_steep ? k : i, is_steep ? i : k, color, share * opacity);
      }
    }
  }
}

void PngCanvas::text(const CanvasText& text, Rgb color) {
  const std::int32_t width = text_width(text.text, text.scale);
  const std::int32_t back = text.anchor == TextAnchor::start ? 0
                            : text.anchor == TextAnchor::end ? width
                                                             : width / 2;
  const std::int32_t x = rounded(text.at.x), y = rounded(text.at.y), height = text_height * text.scale;
  if (text.direction == TextDirection::right)
    draw_text(picture, x - back, y - height, text.text, color, text.scale);
  else
    draw_text(picture, x - height, y + back, text.text, color, text.scale, TextDirection::up);
}

void SvgCanvas::box(const CanvasBox& box, Rgb color) {
  fmt::format_to(
      std::back_inserter(body_),
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" shape-rendering=\"crispEdges\"/>\n",
      short_number(box.left), short_number(box.top), short_number(box.right - box.left),
      short_number(box.bottom - box.top), hex(color));
}

void SvgCanvas::lines(std::span<const CanvasLine> lines, Rgb color, double width, double opacity,
                      const CanvasBox& clip) {
  if (lines.empty()) return;
  const int number = clips_++;
  fmt::format_to(std::back_inserter(body_),
                 "<clipPath id=\"clip{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
                 number, short_number(clip.left), short_number(clip.top),
                 short_number(clip.right - clip.left), short_number(clip.bottom - clip.top));
  fmt::format_to(std::back_inserter(body_),
                 "<path clip-path=\"url(#clip{})\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
                 "stroke-opacity=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"",
                 number, hex(color), short_number(width), short_number(opacity));
  std::string end;
  for (const CanvasLine& line : lines) {
    const std::string from = short_number(line.from.x) + ' ' + short_number(line.from.y);
    const std::string to = short_number(line.to.x) + ' ' + short_number(line.to.y);
    body_ += from == end ? "L" : "M" + from + "L"; // a polygon goes on
    body_ += to;
    end = to;
  }
  body_ += "\"/>\n";
}

void SvgCanvas::text(const CanvasText& text, Rgb color) {
  constexpr double capital_height = 0.72; // of the font's size, in Helvetica and its like
  const char* const anchor = text.anchor == TextAnchor::start ? "start"
                             : text.anchor == TextAnchor::end ? "end"
                                                              : "middle";
  const std::string x = short_number(text.at.x), y = short_number(text.at.y);
  const std::string turn =
      text.direction == TextDirection::up ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "";
  fmt::format_to(std::back_inserter(body_),
                 "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>\n", x,
                 y, short_number(text_height * text.scale / capital_height), anchor, hex(color), turn,
                 xml_text(text.text));
}

void SvgCanvas::cell(const CanvasBox& box, Rgb color) {
  const std::uint32_t key = std::uint32_t{color[0]} << 16 | std::uint32_t{color[1]} << 8 | color[2];
  const auto path = std::back_inserter(cells_[key]);
  fmt::format_to(path, "M{} {}H{}V{}H{}z", short_number(box.left), short_number(box.top),
                 short_number(box.right), short_number(box.bottom), short_number(box.left));
}

void SvgCanvas::finish_cells() {
  body_ += "<g shape-rendering=\"crispEdges\">\n";
  for (const auto& [color, path] : cells_)
    fmt::format_to(std::back_inserter(body_), "<path fill=\"#{:06x}\" d=\"{}\"/>\n", color, path);
  body_ += "</g>\n";
  cells_.clear();
}

std::string SvgCanvas::document(const std::string& title, const std::string& description) const {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                     "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n"
                     "<title>{2}</title>\n<desc>{3}</desc>\n"
                     "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{4}</svg>\n",
                     width_, height_, xml_text(title), xml_text(description), body_);
}

} // namespace masu
