#include "stability/oracle/exact_hit.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>

namespace masu::stability {
namespace {

using Vector = std::array<mpq_class, 3>;

Vector exact(const Vec3d& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class Number>
Number determinant(const std::array<Number, 3>& a, const std::array<Number, 3>& b,
                   const std::array<Number, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Whether double suffices to say that the ray's line misses the triangle: most do, and rationals are slow.
bool surely_misses(const Triangle<double>& t, const Ray<double>& ray) {
  const auto numbers = [](const Vec3d& v) { return std::array{v.x, v.y, v.z}; };
  const Vec3d a = t.a - ray.origin, b = t.b - ray.origin, c = t.c - ray.origin;
  const double farthest = std::max({largest_magnitude(a), largest_magnitude(b), largest_magnitude(c)});
  const double error = 1e-13 * largest_magnitude(ray.direction) * farthest * farthest;
  const std::array d = numbers(ray.direction), p = numbers(a), q = numbers(b), r = numbers(c);
  const auto [low, high] = std::minmax({determinant(d, q, r), determinant(d, r, p), determinant(d, p, q)});
  return low < -error && high > error;
}

// t > 0 of the ray's hit, by Cramer's rule: t d is a mean of the corners as seen from the origin.
std::optional<mpq_class> exact_t(const Triangle<double>& t, const Vector& origin, const Vector& direction) {
  const Vector a = exact(t.a) - origin, b = exact(t.b) - origin, c = exact(t.c) - origin;
  const std::array weights{determinant(direction, b, c), determinant(direction, c, a),
                           determinant(direction, a, b)};
  const auto has = [&](int sign) {
    return std::any_of(weights.begin(), weights.end(), [=](const mpq_class& w) { return sgn(w) == sign; });
  };
  if (has(1) && has(-1)) return {};
  const mpq_class sum = weights[0] + weights[1] + weights[2]; // the direction along the normal
  if (sum == 0) return {};
  mpq_class distance = determinant(a, b, c) / sum;
  if (distance <= 0) return {};
  return distance;
}

} // namespace

const bool exact_hits_available = true;

std::vector<PrimitiveIndex> exact_nearest(std::span<const Triangle<float>> triangles,
                                          const Ray<double>& ray) {
  const Vector origin = exact(ray.origin), direction = exact(ray.direction);
  std::vector<PrimitiveIndex> nearest;
  mpq_class smallest;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle<double> triangle = widened(triangles[i]);
    if (surely_misses(triangle, ray)) continue;
    const std::optional<mpq_class> t = exact_t(triangle, origin, direction);
    if (!t || (!nearest.empty() && *t > smallest)) continue;
    if (nearest.empty() || *t < smallest) {
      nearest.clear();
      smallest = *t;
    }
    nearest.push_back(static_cast<PrimitiveIndex>(i));
  }
  return nearest;
}

} // namespace masu::stability
