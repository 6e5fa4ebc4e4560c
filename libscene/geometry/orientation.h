// The orientation of three points in a plane, and of a triangle seen along a ray, with an exact sign.
//
// A bound on the rounding error decides nearly every case; the rest is summed as an expansion of doubles,
// which is exact on any machine with IEEE doubles and fma. After J. R. Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete & Computational Geometry 18,
// 1997.
#pragma once

#include "libscene/geometry/primitives.h"

namespace masu {

struct Point2 {
  double x, y;
};

inline bool operator==(const Point2& a, const Point2& b) {
  return a.x == b.x && a.y == b.y;
}

// Sums n products as an expansion of 2 n nonoverlapping doubles; returns the largest one that isn't zero,
// which has the sum's sign. Products must not underflow.
template <int n>
MASU_HD inline double sum_of_products(const double (&factors)[n][2]) {
  double parts[2 * n];
  int count = 0;
  const auto add = [&](double carry) {
    for (int i = 0; i < count; ++i) {
      const double sum = carry + parts[i];
      const double of_part = sum - carry;
      parts[i] = (carry - (sum - of_part)) + (parts[i] - of_part); // the sum's rounding error
      carry = sum;
    }
    parts[count++] = carry;
  };
  for (int i = 0; i < n; ++i) {
    const double product = factors[i][0] * factors[i][1];
    add(fma(factors[i][0], factors[i][1], -product));
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
  return sum_of_products<6>({{a.x, b.y}, {-a.x, c.y}, {-c.x, b.y}, {-a.y, b.x}, {a.y, c.x}, {c.y, b.x}});
}

// Whether a ray of such a direction meets a triangle's front: the sign of direction · (b - a) × (c - a),
// below zero. One whose corners are on a line, or that is seen edge-on, shows its front: the normal that it
// is given points against the ray. Exact as long as no product of three numbers is below 1e-270.
template <class Real, class Stored>
MASU_HD inline bool meets_front(const Vec3<Real>& direction, const Triangle<Stored>& triangle) {
  constexpr double u = RealTraits<double>::unit_roundoff;
  const Vec3d d = cast<double>(direction),
              corners[] = {cast<double>(triangle.a), cast<double>(triangle.b), cast<double>(triangle.c)};
  const Vec3d p = corners[1] - corners[0], q = corners[2] - corners[0];
  const auto terms = [&](double x, double y, double of_y, double of_x) { return x * of_y - y * of_x; };
  const auto sizes = [&](double x, double y, double of_y, double of_x) {
    return std::abs(x * of_y) + std::abs(y * of_x);
  };
  const double volume =
      d.x * terms(p.y, p.z, q.z, q.y) + d.y * terms(p.z, p.x, q.x, q.z) + d.z * terms(p.x, p.y, q.y, q.x);
  const double size = std::abs(d.x) * sizes(p.y, p.z, q.z, q.y) + std::abs(d.y) * sizes(p.z, p.x, q.x, q.z) +
                      std::abs(d.z) * sizes(p.x, p.y, q.y, q.x);
  if (std::abs(volume) > 16 * u * size) return volume < 0;
  // Of the 18 products of three numbers, d.x a.y b.z and so on, each as the two numbers that the product of
  // two is: the second is 0 where coordinates are floats.
  constexpr bool is_exact = sizeof(Stored) == sizeof(float);
  double factors[is_exact ? 18 : 36][2];
  int count = 0;
  const auto add = [&](double left, double right, double along) {
    const double product = left * right;
    factors[count][0] = product;
    factors[count++][1] = along;
    if constexpr (!is_exact) {
      factors[count][0] = fma(left, right, -product);
      factors[count++][1] = along;
    }
  };
  for (int corner = 0; corner < 3; ++corner) {
    const Vec3d &a = corners[corner], &b = corners[corner == 2 ? 0 : corner + 1];
    for (int axis = 0; axis < 3; ++axis) {
      const int next = axis == 2 ? 0 : axis + 1, last = axis == 0 ? 2 : axis - 1;
      add(a[next], b[last], d[axis]);
      add(-a[last], b[next], d[axis]);
    }
  }
  return sum_of_products(factors) <= 0;
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
