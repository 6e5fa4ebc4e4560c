#include "tools/draw/value_picture.h"

#include "tools/draw/bitmap_text.h"
#include "tools/draw/color_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace masu {
namespace {

constexpr Rgb white{255, 255, 255};

constexpr std::size_t usual_categories = 12; // easily told apart

// --- Pages ------------------------------------------------------------------------------------------------

std::size_t index_of(std::int32_t width, std::int32_t x, std::int32_t y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

// A picture on a white page: the title above, a column at its right, lines below. Small pictures are shown
// with squares for pixels.
struct Page {
  static constexpr std::int32_t wanted = 480, line_height = text_height + text_descent + 3, bar_room = 68;

  std::int32_t square, text, margin;     // of a pixel, of the font's pixels, in pixels of the page
  std::int32_t left, top, width, height; // of the picture
  std::vector<std::string> lines;
  Picture raster;

  Page(std::int32_t columns, std::int32_t rows, const std::string& title, const std::string& note,
       bool has_bar)
      : square(std::max(1, wanted / std::max(columns, rows))),
        text(std::max(2, std::max(columns, rows) * square / wanted)), margin(6 * text), left(margin),
        top(margin), width(columns * square), height(rows * square), raster(1, 1) {
    const std::int32_t across = std::max(width + (has_bar ? bar_room * text : 0), wanted * text / 2);
    const auto characters = static_cast<std::size_t>(across / (text_advance * text));
    const std::vector<std::string> head = wrapped(title, characters);
    lines = wrapped(note, characters);
    top += static_cast<std::int32_t>(head.size()) * line_height * text + text;
    const std::int32_t body = has_bar ? std::max(height, 60 * text) : height;
    raster = Picture(across + 2 * margin, top + body + margin +
                                              static_cast<std::int32_t>(lines.size()) * line_height * text +
                                              margin / 2);
    write(head, margin);
    write(lines, top + body + margin);
  }

  void set(std::int32_t x, std::int32_t y, Rgb color) {
    raster.fill(left + x * square, top + y * square, square, square, color);
  }
  // Around the picture: white parts of it have an end.
  void frame() {
    constexpr Rgb gray{128, 128, 128};
    const std::int32_t t = std::max(1, text / 2);
    raster.fill(left - t, top - t, width + 2 * t, t, gray);
    raster.fill(left - t, top + height, width + 2 * t, t, gray);
    raster.fill(left - t, top, t, height, gray);
    raster.fill(left + width, top, t, height, gray);
  }

private:
  static std::vector<std::string> wrapped(const std::string& words, std::size_t characters) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t space = words.find(' ', at);
      const std::string word = words.substr(at, space == std::string::npos ? space : space - at);
      at = space == std::string::npos ? words.size() : space + 1;
      if (all.empty() || all.back().size() + 1 + word.size() > characters)
        all.push_back(word);
      else
        all.back() += ' ' + word;
    }
    return all;
  }
  void write(const std::vector<std::string>& written, std::int32_t y) {
    for (const std::string& line : written) {
      draw_text(raster, margin, y, line, Rgb{0, 0, 0}, text);
      y += line_height * text;
    }
  }
};

// --- Scales -----------------------------------------------------------------------------------------------

// From values to 0 … 1.
struct Scale {
  double low = 0, high = 1; // what the colours reach
  double largest = 1;       // of all values
  bool logarithmic = false;
  double offset = 0; // added before the logarithm: 1 for counts, which may be 0

  double operator()(double value) const {
    if (!(high > low)) return 0;
    if (!logarithmic) return (value - low) / (high - low);
    return std::log((value + offset) / (low + offset)) / std::log((high + offset) / (low + offset));
  }
};

Scale scale_of(std::vector<double> finite, Caption::Values values) {
  Scale scale;
  if (finite.empty()) return scale;
  const auto at_share = [&](double share) {
    const auto at =
        finite.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::ranges::nth_element(finite, at);
    return *at;
  };
  scale.largest = at_share(1);
  const double most = at_share(0.999), median = at_share(0.5), smallest = at_share(0);
  scale.high = scale.largest > 1.25 * most && most > smallest ? most : scale.largest;
  scale.low = values == Caption::Values::positive ? smallest : 0;
  scale.offset = values == Caption::Values::counts ? 1 : 0;
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

// Numbers worth a label, the most welcome ones first: ends, then powers of ten and small multiples of them;
// of a linear scale, multiples of such a number.
std::vector<double> labels_of(const Scale& scale, bool whole_numbers) {
  std::vector<double> labels{scale.low, scale.high};
  if (scale.logarithmic) {
    const int first = static_cast<int>(std::floor(std::log10(std::max(scale.low, 1e-30)))) - 1;
    const int last = static_cast<int>(std::ceil(std::log10(scale.high)));
    const bool few_decades = (scale.high + scale.offset) / (scale.low + scale.offset) < 50;
    for (const double digit : few_decades ? std::vector<double>{1, 2, 5} : std::vector<double>{1, 3})
      for (int power = whole_numbers ? 0 : first; power <= last; ++power)
        labels.push_back(digit * std::pow(10, power));
    return labels;
  }
  const double span = scale.high - scale.low;
  if (!(span > 0)) return labels;
  const double power = std::pow(10, std::floor(std::log10(span / 4)));
  double step = power;
  for (const double digit : {2.0, 5.0, 10.0})
    if (span / step > 6) step = digit * power;
  if (whole_numbers) step = std::max(1.0, std::round(step));
  const double first_label = std::ceil(scale.low / step) * step;
  for (int i = 0; first_label + i * step <= scale.high; ++i)
    labels.push_back(first_label + i * step);
  return labels;
}

void draw_bar(Page& page, const ColorMap& colors, const Scale& scale, bool whole_numbers) {
  const std::int32_t unit = page.text, x = page.left + page.width + 6 * unit, width = 8 * unit,
                     height = std::max(page.height, 60 * unit);
  for (std::int32_t y = 0; y < height; ++y)
    page.raster.fill(x, page.top + y, width, 1, colors(1 - static_cast<double>(y) / (height - 1)));
  std::vector<std::int32_t> taken;
  for (const double label : labels_of(scale, whole_numbers)) {
    if (label < scale.low || label > scale.high) continue;
    const auto y = page.top + static_cast<std::int32_t>((1 - scale(label)) * (height - 1));
    const auto is_near = [&](std::int32_t other) { return std::abs(y - other) < 13 * unit; };
    if (std::ranges::any_of(taken, is_near)) continue;
    taken.push_back(y);
    page.raster.fill(x + width, y - unit / 2, 3 * unit, unit, Rgb{0, 0, 0});
    const std::int32_t text_y = std::clamp(y - 3 * unit, page.top, page.top + height - 7 * unit);
    draw_text(page.raster, x + width + 5 * unit, text_y, number(label), Rgb{0, 0, 0}, unit);
  }
}

// --- Names ------------------------------------------------------------------------------------------------

// A category for each name: no two that touch in the picture share one.
std::unordered_map<std::int32_t, std::size_t> categories_of(const ValueMap<std::int32_t>& map) {
  std::vector<std::pair<std::int32_t, std::int32_t>> touching; // both ways
  std::unordered_map<std::int32_t, std::size_t> categories;
  for (std::int32_t y = 0; y < map.height; ++y) {
    for (std::int32_t x = 0; x < map.width; ++x) {
      const std::int32_t name = map.values[index_of(map.width, x, y)];
      if (name < 0) continue;
      categories.emplace(name, 0);
      const auto touch = [&](std::int32_t other_x, std::int32_t other_y) {
        if (other_x < 0 || other_x >= map.width || other_y >= map.height) return;
        const std::int32_t other = map.values[index_of(map.width, other_x, other_y)];
        if (other < 0 || other == name) return;
        touching.emplace_back(name, other);
        touching.emplace_back(other, name);
      };
      touch(x + 1, y);
      for (const std::int32_t dx : {-1, 0, 1})
        touch(x + dx, y + 1);
    }
  }
  std::ranges::sort(touching);
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  std::vector<std::int32_t> names;
  names.reserve(categories.size());
  for (const auto& [name, category] : categories)
    names.push_back(name);
  std::ranges::sort(names);
  // In order of names, each takes the first that no smaller neighbour has, from one of the usual ones on.
  auto next = touching.begin();
  for (const std::int32_t name : names) {
    std::vector<std::size_t> used;
    for (; next != touching.end() && next->first == name; ++next)
      if (next->second < name) used.push_back(categories[next->second]);
    const auto is_free = [&](std::size_t c) { return std::ranges::find(used, c) == used.end(); };
    const std::size_t start = static_cast<std::uint32_t>(name) * 2654435769U >> 16;
    std::size_t category = start % usual_categories;
    for (std::size_t tried = 0; tried < usual_categories && !is_free(category); ++tried)
      category = (start + tried + 1) % usual_categories;
    for (std::size_t more = usual_categories; !is_free(category); ++more)
      category = more;
    categories[name] = category;
  }
  return categories;
}

std::string joined(const std::string& text, const std::string& without) {
  return without.empty() ? text : text + "; white: " + without;
}

} // namespace

Picture value_picture(const ValueMap<double>& map, const Caption& caption) {
  std::vector<double> finite;
  std::ranges::copy_if(map.values, std::back_inserter(finite), [](double v) { return std::isfinite(v); });
  const Scale scale = scale_of(finite, caption.values);
  std::string note = fmt::format("{}, {} to {}, {} scale", caption.unit, number(scale.low),
                                 number(scale.high), scale.logarithmic ? "log" : "linear");
  if (scale.high < scale.largest)
    note += fmt::format("; 0.1 % of the values are larger, up to {}", number(scale.largest));
  if (finite.empty()) note = caption.unit;
  Page page(map.width, map.height, caption.title,
            joined(note, finite.size() < map.values.size() ? caption.without : ""), true);
  const ColorMap colors;
  for (std::int32_t y = 0; y < map.height; ++y)
    for (std::int32_t x = 0; x < map.width; ++x) {
      const double value = map.values[index_of(map.width, x, y)];
      page.set(x, y, std::isfinite(value) ? colors(scale(value)) : white);
    }
  page.frame();
  if (!finite.empty()) draw_bar(page, colors, scale, caption.values == Caption::Values::counts);
  return page.raster;
}

Picture name_picture(const ValueMap<std::int32_t>& map, const Caption& caption) {
  const auto categories = categories_of(map);
  std::vector<Rgb> colors;
  for (const auto& [name, category] : categories)
    for (std::size_t k = colors.size(); k <= category; ++k)
      colors.push_back(category_color(k));
  const bool has_misses = std::ranges::any_of(map.values, [](std::int32_t name) { return name < 0; });
  Page page(
      map.width, map.height, caption.title,
      joined(fmt::format("{} {} seen; neighbours have different colours", categories.size(), caption.unit),
             has_misses ? caption.without : ""),
      false);
  for (std::int32_t y = 0; y < map.height; ++y)
    for (std::int32_t x = 0; x < map.width; ++x) {
      const std::int32_t name = map.values[index_of(map.width, x, y)];
      page.set(x, y, name < 0 ? white : colors[categories.at(name)]);
    }
  page.frame();
  return page.raster;
}

Picture normal_picture(const ValueMap<Vec3f>& map, const Caption& caption) {
  const auto color = [](const Vec3f& n) { return n == Vec3f{0, 0, 0} ? white : normal_color(n); };
  const bool has_misses = std::ranges::any_of(map.values, [](const Vec3f& n) { return n == Vec3f{0, 0, 0}; });
  Page page(map.width, map.height, caption.title,
            joined("red, green, blue: x, y, z of the normal from -1 to 1", has_misses ? caption.without : ""),
            true);
  for (std::int32_t y = 0; y < map.height; ++y)
    for (std::int32_t x = 0; x < map.width; ++x)
      page.set(x, y, color(map.values[index_of(map.width, x, y)]));
  page.frame();
  // The colours of the axes' directions.
  const std::int32_t unit = page.text, x = page.left + page.width + 6 * unit;
  std::int32_t y = page.top;
  for (const auto& [name, direction] : {std::pair<const char*, Vec3f>{"+x", {1, 0, 0}},
                                        {"-x", {-1, 0, 0}},
                                        {"+y", {0, 1, 0}},
                                        {"-y", {0, -1, 0}},
                                        {"+z", {0, 0, 1}},
                                        {"-z", {0, 0, -1}}}) {
    page.raster.fill(x, y, 8 * unit, 8 * unit, color(direction));
    draw_text(page.raster, x + 11 * unit, y + unit / 2, name, Rgb{0, 0, 0}, unit);
    y += 10 * unit;
  }
  return page.raster;
}

} // namespace masu
