// The orientation of three points in a plane, with an exact sign.
//
// A bound on the rounding error decides nearly every case; the rest is summed as an expansion of doubles,
// which is exact on any machine with IEEE doubles and fma. After J. R. Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational Geometry 18,
// 1997.
#pragma once

#include "libscene/geometry/real.h"

#include <array>

namespace masu {

struct Point2 {
  double x, y;
};

inline bool operator==(const Point2& a, const Point2& b) {
  return a.x == b.x && a.y == b.y;
}

// Sums six products as an expansion of twelve nonoverlapping doubles; returns the largest one that isn't
// zero, which has the sum's sign. Products must not underflow.
inline double sum_of_products(const std::array<std::array<double, 2>, 6>& factors) {
  std::array<double, 12> parts{};
  std::size_t count = 0;
  const auto add = [&](double carry) {
    for (std::size_t i = 0; i < count; ++i) {
      const double sum = carry + parts[i];
      const double of_part = sum - carry;
      parts[i] = (carry - (sum - of_part)) + (parts[i] - of_part); // the sum's rounding error
      carry = sum;
    }
    parts[count++] = carry;
  };
  for (const auto& [a, b] : factors) {
    const double product = a * b;
    add(fma(a, b, -product));
    add(product);
  }
  while (count > 1 && parts[count - 1] == 0)
    --count;
  return parts[count - 1];
}

// Twice the area of the triangle: positive where a, b, c run counter-clockwise, zero only when they are
// collinear. The value is rounded, its sign exact. Coordinates should be near 1, far from underflow.
inline double orientation(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double u = RealTraits<double>::unit_roundoff;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double area = left - right;
  if (std::abs(area) >= (3 + 16 * u) * u * (std::abs(left) + std::abs(right))) return area;
  return sum_of_products({{{a.x, b.y}, {-a.x, c.y}, {-c.x, b.y}, {-a.y, b.x}, {a.y, c.x}, {c.y, b.x}}});
}

// Of the corner p of an ear that is cut off from a to b, whose orientation is `turn`: the sine over the cut's
// squared length; 0 where two of them are one point.
inline double ear_shape(const Point2& a, const Point2& p, const Point2& b, double turn) {
  const auto square = [](const Point2& from, const Point2& to) {
    return (from.x - to.x) * (from.x - to.x) + (from.y - to.y) * (from.y - to.y);
  };
  const double weight = square(a, b) * std::sqrt(square(a, p)) * std::sqrt(square(p, b));
  return weight > 0 ? turn / weight : 0;
}

} // namespace masu
