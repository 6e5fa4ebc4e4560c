#include "tools/report/slice_place.h"

#include "libscene/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace masu {

SlicePlane parse_slice(const std::string& text, const GridLayout& finest) {
  constexpr const char* place = "--slice";
  const auto fail = [&]() -> SlicePlane {
    throw Error(ErrorCode::usage, place,
                fmt::format("'{}' isn't AXIS=K, AXIS=P% or AXIS@X with axis x, y or z", text));
  };
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || (text[1] != '=' && text[1] != '@')) return fail();
  const int axis = text[0] - 'x';
  const char *const number = text.c_str() + 2, *const last = text.c_str() + text.size();
  if (std::string_view(number).find_first_not_of("0123456789+-.eE%") != std::string_view::npos) return fail();
  char* end = nullptr;
  if (text[1] == '=' && text.back() != '%') {
    errno = 0;
    const long long layer = std::strtoll(number, &end, 10);
    return end == last && errno == 0 ? plane_of_layer(finest, axis, layer, place) : fail();
  }
  const double value = std::strtod(number, &end);
  if (text[1] == '@')
    return end == last && std::isfinite(value) ? plane_at(finest, axis, value, place) : fail();
  if (end == number || end + 1 != last || !std::isfinite(value)) return fail();
  if (!(value >= 0 && value <= 100))
    throw Error(ErrorCode::usage, place, fmt::format("'{}' lies outside: give 0% to 100%", text));
  const double low = finest.space.min[axis], high = finest.space.max[axis];
  return plane_at(finest, axis, value == 100 ? high : low + value / 100 * (high - low), place);
}

SliceWindow parse_window(const std::string& text, const GridLayout& finest, int axis) {
  const SliceWindow whole = window_of(finest, axis);
  if (text.empty()) return whole;
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::usage, "--window", fmt::format("'{}' {}", text, why));
  };
  std::array<double, 4> numbers{};
  const char* at = text.c_str();
  for (std::size_t i = 0; i < 4; ++i) {
    char* end = nullptr;
    numbers[i] = std::strtod(at, &end);
    if (end == at || !std::isfinite(numbers[i]) || *end != (i < 3 ? ',' : '\0'))
      fail("isn't LEFT,BOTTOM,RIGHT,TOP in scene units");
    at = end + 1;
  }
  SliceWindow window{};
  const std::array<int, 2> axes = slice_axes(axis);
  for (std::size_t i = 0; i < 2; ++i) {
    window.min[i] = std::max(numbers[i], whole.min[i]);
    window.max[i] = std::min(numbers[i + 2], whole.max[i]);
    if (!(window.min[i] < window.max[i]))
      fail(fmt::format("has nothing of the grid's space: along {} that is from {} to {}", "xyz"[axes[i]],
                       whole.min[i], whole.max[i]));
  }
  // A plot needs coordinates that differ.
  for (std::size_t i = 0; i < 2; ++i) {
    if (window.max[i] - window.min[i] < 1e-12 * std::max(std::abs(window.min[i]), std::abs(window.max[i])))
      fail("is too small");
  }
  return window;
}

} // namespace masu
