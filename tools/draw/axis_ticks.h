// Round numbers to label an axis or a colour bar with.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace masu {

// Multiples of 1, 2 or 5 times a power of ten from low to high, at most `most` (2 or more) of them; whole
// numbers alone on request.
inline std::vector<double> linear_ticks(double low, double high, int most, bool whole = false) {
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

// Of a logarithmic axis, 0 < low ≤ high: 1, 2 and 5 times powers of ten, or powers alone where these are more
// than `most`.
inline std::vector<double> logarithmic_ticks(double low, double high, std::size_t most) {
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

inline std::string tick_text(double tick) {
  return fmt::format("{:.6g}", tick);
}

} // namespace masu
