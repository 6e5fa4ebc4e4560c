#include "tools/draw/value_picture.h"

#include "tools/common/color_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace masu {
namespace {

constexpr std::size_t usual_categories = 12; // easily told apart

// --- Pages ------------------------------------------------------------------------------------------------

std::size_t index_of(std::int32_t width, std::int32_t x, std::int32_t y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// A picture on a white page: the title above, a legend at its right, a note below. Small pictures are shown
// with squares for pixels.
struct Page {
  static constexpr std::int32_t wanted = 480; // pixels of the picture's longer side, about

  std::int32_t columns, side; // of the picture; of a pixel's square
  double em;                  // the text's size
  std::vector<Rgb> colors;
  TextBlock title{}, note{};
  DrawingBox picture{};
  double bottom = 0; // of the picture and the legend beside it

  Page(std::int32_t width, std::int32_t height)
      : columns(width), side(std::max(1, wanted / std::max(width, height))),
        em(std::max(14.0, std::round(std::sqrt(1.0 * width * height) * side / 28))) {
    colors.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  }
  double height() const { return static_cast<double>(colors.size()) / columns * side; } // of the picture
  double legend_height() const { return std::max(height(), 9 * em); }
  double legend_left() const { return picture.right + std::round(0.8 * em); }

  // The drawing takes the page's pixels. `legend`: the width of what draw_legend(cairo, page) draws beside
  // the picture; 0: nothing.
  template <class DrawLegend>
  Drawing drawing(const std::string& title_text, const std::string& note_text, double legend,
                  const DrawLegend& draw_legend) {
    const double margin = std::round(0.8 * em);
    const double width = columns * side, across = std::max(width + legend, 16 * em);
    title = text_block(title_text, em, across);
    note = text_block(note_text, 0.85 * em, across);
    const double top = std::ceil(margin + title.height() + 0.4 * em);
    picture = {margin, top, margin + width, top + height()};
    bottom = top + (legend > 0 ? legend_height() : height());
    const double end = bottom + 0.7 * em + note.height() + 0.5 * margin;
    const auto draw = [page = std::move(*this), margin, draw_legend](cairo_t* cairo) {
      constexpr Rgb gray{128, 128, 128}; // of a frame: white parts of the picture have an end
      draw_pixels(cairo, static_cast<std::int32_t>(page.picture.left),
                  static_cast<std::int32_t>(page.picture.top), page.side, page.columns, page.colors);
      draw_frame(cairo, page.picture, std::max(1.0, std::round(page.em / 16)), gray);
      draw_legend(cairo, page);
      draw_text_block(cairo, margin, margin, page.title);
      draw_text_block(cairo, margin, page.bottom + 0.7 * page.em, page.note);
    };
    return {static_cast<std::int32_t>(std::ceil(across + 2 * margin)),
            static_cast<std::int32_t>(std::ceil(end)), draw};
  }
};

// --- Scales -----------------------------------------------------------------------------------------------

// Of all values, which are finite.
ColorScale scale_of(std::vector<double> finite, Caption::Values values) {
  ColorScale scale;
  if (finite.empty()) return scale;
  const auto at_share = [&](double share) {
    const auto at =
        finite.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::ranges::nth_element(finite, at);
    return *at;
  };
  const double largest = at_share(1), most = at_share(0.999), median = at_share(0.5), smallest = at_share(0);
  scale.high = largest > 1.25 * most && most > smallest ? most : largest;
  scale.low = values == Caption::Values::positive ? smallest : 0;
  scale.whole = values == Caption::Values::counts;
  scale.offset = scale.whole ? 1 : 0;
  // Distances that span more than a factor of 3; large counts, half of them in the lowest tenth of a linear
  // scale.
  scale.logarithmic = values == Caption::Values::positive
                          ? scale.low > 0 && scale.high > 3 * scale.low
                          : scale.offset > 0 && scale.high > 50 && median < scale.high / 10;
  return scale;
}

std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

// --- Names ------------------------------------------------------------------------------------------------

// A category for each name: no two that touch in the picture share one.
std::unordered_map<std::int32_t, std::size_t> categories_of(const ValueMap<std::int32_t>& map) {
  std::map<std::int32_t, std::vector<std::int32_t>> neighbours; // smaller ones, with repetitions
  for (std::int32_t y = 0; y < map.height; ++y) {
    for (std::int32_t x = 0; x < map.width; ++x) {
      const std::int32_t name = map.values[index_of(map.width, x, y)];
      if (name < 0) continue;
      neighbours.try_emplace(name);
      const auto touch = [&](std::int32_t other_x, std::int32_t other_y) {
        if (other_x < 0 || other_x >= map.width || other_y >= map.height) return;
        const std::int32_t other = map.values[index_of(map.width, other_x, other_y)];
        if (other >= 0 && other != name) neighbours[std::max(name, other)].push_back(std::min(name, other));
      };
      touch(x + 1, y);
      for (const std::int32_t dx : {-1, 0, 1})
        touch(x + dx, y + 1);
    }
  }
  // In order of names, each takes the first that no smaller neighbour has, from one of the usual ones on.
  std::unordered_map<std::int32_t, std::size_t> categories;
  for (const auto& [name, smaller] : neighbours) {
    std::set<std::size_t> used;
    for (const std::int32_t other : smaller)
      used.insert(categories.at(other));
    const std::size_t start = static_cast<std::uint32_t>(name) * 2654435769U >> 16;
    std::size_t category = start % usual_categories;
    for (std::size_t tried = 0; tried < usual_categories && used.contains(category); ++tried)
      category = (start + tried + 1) % usual_categories;
    for (std::size_t more = usual_categories; used.contains(category); ++more)
      category = more;
    categories.emplace(name, category);
  }
  return categories;
}

std::string joined(const std::string& text, const std::string& without) {
  return without.empty() ? text : text + "; white: " + without;
}

} // namespace

Drawing value_picture(const ValueMap<double>& map, const Caption& caption) {
  std::vector<double> finite;
  std::ranges::copy_if(map.values, std::back_inserter(finite), [](double v) { return std::isfinite(v); });
  const ColorScale scale = caption.high > 0 ? ColorScale{0, caption.high, caption.high > 50, 1, true}
                                            : scale_of(finite, caption.values);
  std::string note = fmt::format("{}, {} to {}, {} scale", caption.unit, number(scale.low),
                                 number(scale.high), scale.logarithmic ? "log" : "linear");
  if (finite.empty())
    note = caption.unit;
  else if (const double largest = std::ranges::max(finite); scale.high < largest)
    note += fmt::format("; {} larger, up to {}", caption.high > 0 ? "some are" : "0.1 % of the values are",
                        number(largest));
  Page page(map.width, map.height);
  const ColorMap colors;
  for (const double value : map.values)
    page.colors.push_back(std::isfinite(value) ? colors(scale.share(value)) : white);
  const double em = page.em, width = std::round(em), height = page.legend_height();
  std::vector<ColorBarLabel> labels;
  if (!finite.empty()) labels = color_bar_labels(scale, height, em);
  const double legend = 1.8 * em + color_bar_label_width(labels, em);
  return page.drawing(caption.title, joined(note, finite.size() < map.values.size() ? caption.without : ""),
                      legend, [colors, labels, width](cairo_t* cairo, const Page& drawn) {
                        if (labels.empty()) return;
                        const double left = drawn.legend_left();
                        draw_color_bar(cairo, {left, drawn.picture.top, left + width, drawn.bottom}, colors,
                                       labels, drawn.em);
                      });
}

Drawing name_picture(const ValueMap<std::int32_t>& map, const Caption& caption) {
  const auto categories = categories_of(map);
  std::vector<Rgb> colors;
  for (const auto& [name, category] : categories)
    for (std::size_t k = colors.size(); k <= category; ++k)
      colors.push_back(category_color(k));
  const bool has_misses = std::ranges::any_of(map.values, [](std::int32_t name) { return name < 0; });
  Page page(map.width, map.height);
  for (const std::int32_t name : map.values)
    page.colors.push_back(name < 0 ? white : colors[categories.at(name)]);
  return page.drawing(
      caption.title,
      joined(fmt::format("{} {} seen; neighbours have different colours", categories.size(), caption.unit),
             has_misses ? caption.without : ""),
      0, [](cairo_t*, const Page&) {});
}

Drawing normal_picture(const ValueMap<Vec3f>& map, const Caption& caption) {
  const auto color = [](const Vec3f& n) { return n == Vec3f{0, 0, 0} ? white : normal_color(n); };
  const bool has_misses = std::ranges::any_of(map.values, [](const Vec3f& n) { return n == Vec3f{0, 0, 0}; });
  Page page(map.width, map.height);
  std::ranges::transform(map.values, std::back_inserter(page.colors), color);
  const auto draw_directions = [](cairo_t* cairo, const Page& drawn) {
    const double em = drawn.em, left = drawn.legend_left(), side = std::round(em);
    double top = drawn.picture.top;
    for (const auto& [name, direction] : {std::pair<const char*, Vec3f>{"+x", {1, 0, 0}},
                                          {"\u2212x", {-1, 0, 0}},
                                          {"+y", {0, 1, 0}},
                                          {"\u2212y", {0, -1, 0}},
                                          {"+z", {0, 0, 1}},
                                          {"\u2212z", {0, 0, -1}}}) {
      fill_box(cairo, {left, top, left + side, top + side}, normal_color(direction));
      draw_text(cairo, left + side + 0.4 * em, top + (side + capital_height * em) / 2, name, em);
      top += std::round(1.5 * em);
    }
  };
  return page.drawing(
      caption.title,
      joined("red, green, blue: x, y, z of the normal from -1 to 1", has_misses ? caption.without : ""),
      2.2 * page.em + text_width("+x", page.em), draw_directions);
}

} // namespace masu
