#include "tools/lists/ray_csv.h"

#include "libscene/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace masu {
namespace {

// In the order of a ray's 8 numbers.
constexpr std::array<std::string_view, 8> names{"ox", "oy", "oz", "tmin", "dx", "dy", "dz", "tmax"};
constexpr std::size_t t_min = 3, t_max = 7;
constexpr const char* example = "ox,oy,oz,dx,dy,dz";

constexpr std::size_t longest_line = std::size_t{1} << 16;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

const char* after_blanks(const char* position, const char* end) {
  return std::find_if_not(position, end, is_blank);
}

// Up to the next comma, without blanks around it.
std::string_view field_at(const char* position, const char* end) {
  position = after_blanks(position, end);
  const char* last = std::find(position, end, ',');
  while (last > position && is_blank(last[-1]))
    --last;
  return {position, last};
}

std::string quoted(std::string_view field) {
  constexpr std::size_t longest = 24;
  return fmt::format("'{}{}'", field.substr(0, longest), field.size() > longest ? "..." : "");
}

} // namespace

void RayCsv::fail(std::string_view line, const char* position, const std::string& what) const {
  throw Error(ErrorCode::input, fmt::format("{}:{}:{}", name_, line_, position - line.data() + 1), what);
}

// Calls act(line) for the next lines that aren't blank, up to so many. Returns the bytes of those lines.
template <class Act>
std::size_t RayCsv::each_line(std::string_view text, bool is_all, std::size_t count, const Act& act) {
  std::size_t begin = 0;
  while (count > 0 && begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line)
      throw Error(ErrorCode::input, fmt::format("{}:{}", name_, line_ + 1),
                  fmt::format("is longer than {} bytes: isn't a list of rays", longest_line));
    if (end == text.size() && !is_all) break;
    const std::string_view line = text.substr(begin, end - begin);
    begin = std::min(end + 1, text.size());
    ++line_;
    if (std::ranges::all_of(line, is_blank)) continue;
    act(line);
    --count;
  }
  return begin;
}

std::size_t RayCsv::read_names(std::string_view text, bool is_all) {
  constexpr std::string_view byte_order_mark("\xef\xbb\xbf");
  const std::size_t before = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  const auto read = [this](std::string_view line) {
    const char* const end = line.data() + line.size();
    const char* position = after_blanks(line.data(), end);
    if (*position == '#') ++position; // as NumPy's savetxt() writes a header
    while (true) {
      const std::string_view field = field_at(position, end);
      const auto* const found = std::ranges::find(names, field);
      const auto index = static_cast<std::size_t>(found - names.begin());
      if (found == names.end())
        fail(line, position,
             fmt::format("{} isn't one of the columns {}: begin with a line such as {}", quoted(field),
                         fmt::join(names, ", "), example));
      if (std::ranges::count(columns_, index) > 0) fail(line, position, fmt::format("has {} twice", field));
      columns_.push_back(index);
      position = std::find(position, end, ',');
      if (position == end) break;
      ++position;
    }
    for (std::size_t index = 0; index < names.size(); ++index) {
      const bool is_there = std::ranges::count(columns_, index) > 0,
                 is_limit = index == t_min || index == t_max;
      if (!is_there && !is_limit)
        fail(line, line.data(),
             fmt::format("has no column {}: begin with a line such as {}", names[index], example));
      has_limits_ = has_limits_ || (is_there && is_limit);
    }
  };
  const std::size_t taken = each_line(text.substr(before), is_all, 1, read);
  if (!columns_.empty()) return before + taken;
  if (is_all)
    throw Error(ErrorCode::input, name_,
                fmt::format("has no line of columns' names: begin with one such as {}", example));
  line_ = 0; // of blank lines, which are read again
  return 0;
}

// The number at a position, which is then at what follows it: a comma or the line's end.
double RayCsv::number(std::string_view line, const char*& position) const {
  const char* const end = line.data() + line.size();
  const char* const start = after_blanks(position, end);
  double value = 0;
  const auto [stop, error] = std::from_chars(start, end, value);
  position = after_blanks(stop, end);
  const auto quoted_field = [&] { return quoted(field_at(start, end)); };
  if (error == std::errc::invalid_argument || (position != end && *position != ','))
    fail(line, start, quoted_field() + " isn't a number");
  if (error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(start, stop).c_str(), nullptr); // nearly 0, or infinite
    if (std::isinf(value)) fail(line, start, quoted_field() + " is too large for a number of 64 bits");
  }
  return value;
}

std::size_t RayCsv::read_rays(std::string_view text, bool is_all, std::size_t count,
                              std::vector<double>& rays) {
  std::array<double, 8> ray{};
  ray[t_max] = std::numeric_limits<double>::infinity();
  return each_line(text, is_all, count, [&](std::string_view line) {
    const char* const end = line.data() + line.size();
    const char* position = line.data();
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      ray[columns_[i]] = number(line, position);
      if ((position == end) != (i + 1 == columns_.size()))
        fail(line, position,
             fmt::format("the line must have {} numbers, as the first one has names", columns_.size()));
      if (position != end) ++position; // a comma
    }
    for (std::size_t index = 0; index < ray.size(); ++index) {
      if (has_limits_ || (index != t_min && index != t_max)) rays.push_back(ray[index]);
    }
  });
}

std::size_t RayCsv::skip_rays(std::string_view text, bool is_all, std::size_t count, std::uint64_t& rays) {
  return each_line(text, is_all, count, [&](std::string_view) { ++rays; });
}

} // namespace masu
