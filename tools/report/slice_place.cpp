#include "tools/report/slice_place.h"

#include "libscene/base/error.h"
#include "tools/common/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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
  const bool is_share = text[1] == '=' && text.back() == '%';
  const std::string_view number = std::string_view(text).substr(2, text.size() - (is_share ? 3 : 2));
  if (text[1] == '=' && !is_share) {
    std::array<std::int64_t, 1> layer{};
    return read_numbers(number, ',', layer) ? plane_of_layer(finest, axis, layer[0], place) : fail();
  }
  std::array<double, 1> read{};
  const double& value = read[0];
  if (!read_numbers(number, ',', read) || !std::isfinite(value)) return fail();
  if (text[1] == '@') return plane_at(finest, axis, value, place);
  if (!(value >= 0 && value <= 100))
    throw Error(ErrorCode::usage, place, fmt::format("'{}' lies outside: give 0% to 100%", text));
  return plane_at_share(finest, axis, value / 100, place);
}

SliceWindow parse_window(const std::string& text, const GridLayout& finest, int axis) {
  const SliceWindow whole = window_of(finest, axis);
  if (text.empty()) return whole;
  const auto fail = [&](const std::string& why) {
    throw Error(ErrorCode::usage, "--window", fmt::format("'{}' {}", text, why));
  };
  std::array<double, 4> numbers{};
  if (!read_numbers(text, ',', numbers) ||
      !std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
    fail("isn't LEFT,BOTTOM,RIGHT,TOP in scene units");
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
