// Several rays, or as many times the same one, each against a triangle of its own: eight in float32, four in
// float64. Host only, with AVX2 and FMA.
#pragma once

#include "libscene/geometry/lanes.h"
#include "libscene/geometry/triangle.h"

namespace masu {

// intersect() of triangle.h lane by lane, with the same operations in the same order, so that t has the same
// bits; of corners relative to the rays' origins. Returns where t > 0; elsewhere `t` is anything.
template <class Real>
MASU_ALWAYS_INLINE LaneMask<Real> intersect(const WatertightRay<Lanes<Real>>& ray, const Vec3<Lanes<Real>>& a,
                                            const Vec3<Lanes<Real>>& b, const Vec3<Lanes<Real>>& c,
                                            Lanes<Real>& t) {
  using Numbers = Lanes<Real>;
  const EdgeFunctions<Numbers> e = edge_functions(ray, a, b, c);
  const Numbers zero = 0, lowest = min(e.a, min(e.b, e.c)), highest = max(e.a, max(e.b, e.c)),
                sum = e.a + e.b + e.c;
  const LaneMask<Real> missed = ((lowest < zero) & (zero < highest)) | (sum == zero);
  const Numbers scale = select((sum < 0x1p-60F) & (Numbers(-0x1p-60F) < sum), Numbers(0x1p60F), 1);
  const Numbers weighted = fma(e.a * scale, dot(ray.direction, a),
                               fma(e.b * scale, dot(ray.direction, b), e.c * scale * dot(ray.direction, c)));
  t = fast_divide(weighted, sum * scale) * ray.inverse_square;
  return without(zero < t, missed);
}

// A corner of each of four triangles.
template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> corners(const Triangle<double>* triangles, const PrimitiveIndex* numbers,
                                             Vec3<double> Triangle<double>::*of) {
  const auto load = [&](int i) __attribute__((always_inline)) {
    return _mm256_loadu_pd(&(triangles[numbers[i]].*of).x);
  };
  const __m256d c0 = load(0), c1 = load(1), c2 = load(2), c3 = load(3);
  const __m256d xz01 = _mm256_unpacklo_pd(c0, c1), xz23 = _mm256_unpacklo_pd(c2, c3);
  const __m128d y01 = _mm_unpackhi_pd(_mm256_castpd256_pd128(c0), _mm256_castpd256_pd128(c1)),
                y23 = _mm_unpackhi_pd(_mm256_castpd256_pd128(c2), _mm256_castpd256_pd128(c3));
  return {_mm256_permute2f128_pd(xz01, xz23, 0x20), _mm256_set_m128d(y23, y01),
          _mm256_permute2f128_pd(xz01, xz23, 0x31)};
}
// Of eight; or, for arithmetic in float64, of four, whose numbers lie in the low halves.
template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> corners(const Triangle<float>* triangles, const PrimitiveIndex* numbers,
                                             Vec3<float> Triangle<float>::*of) {
  const auto load = [&](int i) __attribute__((always_inline)) {
    return _mm_load_ps(&(triangles[numbers[i]].*of).x);
  };
  const auto two = [&](int i) __attribute__((always_inline)) {
    if constexpr (sizeof(Real) == sizeof(float))
      return _mm256_set_m128(load(i + 4), load(i));
    else
      return _mm256_zextps128_ps256(load(i));
  };
  const __m256 c0 = two(0), c1 = two(1), c2 = two(2), c3 = two(3);
  const __m256d xy01 = _mm256_castps_pd(_mm256_unpacklo_ps(c0, c1)),
                xy23 = _mm256_castps_pd(_mm256_unpacklo_ps(c2, c3)),
                z01 = _mm256_castps_pd(_mm256_unpackhi_ps(c0, c1)),
                z23 = _mm256_castps_pd(_mm256_unpackhi_ps(c2, c3));
  const auto lanes = [](__m256d v) { return part_of<Real>(_mm256_castpd_ps(v), 0); };
  return {lanes(_mm256_unpacklo_pd(xy01, xy23)), lanes(_mm256_unpackhi_pd(xy01, xy23)),
          lanes(_mm256_unpacklo_pd(z01, z23))};
}

// The same of a triangle for each lane: all(&Triangle<Stored>::a) are their corners.
template <class Stored, class Real, class All>
MASU_ALWAYS_INLINE LaneMask<Real> intersect(const WatertightRay<Lanes<Real>>& ray, const All& all,
                                            Lanes<Real>& t) {
  const Vec3<Lanes<Real>> a = all(&Triangle<Stored>::a) - ray.origin,
                          b = all(&Triangle<Stored>::b) - ray.origin,
                          c = all(&Triangle<Stored>::c) - ray.origin;
  return intersect(ray, a, b, c, t);
}
template <class Real, class Stored>
MASU_ALWAYS_INLINE LaneMask<Real> intersect(const WatertightRay<Lanes<Real>>& ray,
                                            const Triangle<Stored>* triangles, const PrimitiveIndex* numbers,
                                            Lanes<Real>& t) {
  return intersect<Stored>(
      ray, [&](auto corner) { return corners<Real>(triangles, numbers, corner); }, t);
}

} // namespace masu
