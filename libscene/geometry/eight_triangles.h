// Eight rays, or eight times the same one, each against a triangle of its own. Host only, with AVX2 and FMA.
#pragma once

#include "libscene/geometry/floats8.h"
#include "libscene/geometry/triangle.h"

namespace masu {

// intersect() of triangle.h lane by lane, with the same operations in the same order, so that t has the same
// bits; of corners relative to the rays' origins. Returns where t > 0; elsewhere `t` is anything.
MASU_ALWAYS_INLINE Mask8 intersect(const WatertightRay<Floats8>& ray, const Vec3<Floats8>& a,
                                   const Vec3<Floats8>& b, const Vec3<Floats8>& c, Floats8& t) {
  const EdgeFunctions<Floats8> e = edge_functions(ray, a, b, c);
  const Floats8 zero = 0, lowest = min(e.a, min(e.b, e.c)), highest = max(e.a, max(e.b, e.c)),
                sum = e.a + e.b + e.c;
  const Mask8 missed = ((lowest < zero) & (zero < highest)) | (sum == zero);
  const Floats8 scale = select((sum < 0x1p-60F) & (Floats8(-0x1p-60F) < sum), 0x1p60F, 1);
  const Floats8 weighted = fma(e.a * scale, dot(ray.direction, a),
                               fma(e.b * scale, dot(ray.direction, b), e.c * scale * dot(ray.direction, c)));
  t = fast_divide(weighted, sum * scale) * ray.inverse_square;
  return without(zero < t, missed);
}

// The same of a triangle for each lane.
MASU_ALWAYS_INLINE Mask8 intersect(const WatertightRay<Floats8>& ray, const Triangle<float>* triangles,
                                   const PrimitiveIndex* eight, Floats8& t) {
  // A corner of each, relative to the ray's origin.
  const auto corner = [&](Vec3<float> Triangle<float>::*of) {
    const auto load = [&](int i) { return _mm_load_ps(&(triangles[eight[i]].*of).x); };
    const auto two = [&](int i) { return _mm256_set_m128(load(i + 4), load(i)); };
    const __m256 c0 = two(0), c1 = two(1), c2 = two(2), c3 = two(3);
    const __m256d xy01 = _mm256_castps_pd(_mm256_unpacklo_ps(c0, c1)),
                  xy23 = _mm256_castps_pd(_mm256_unpacklo_ps(c2, c3)),
                  z01 = _mm256_castps_pd(_mm256_unpackhi_ps(c0, c1)),
                  z23 = _mm256_castps_pd(_mm256_unpackhi_ps(c2, c3));
    return Vec3<Floats8>{_mm256_castpd_ps(_mm256_unpacklo_pd(xy01, xy23)),
                         _mm256_castpd_ps(_mm256_unpackhi_pd(xy01, xy23)),
                         _mm256_castpd_ps(_mm256_unpacklo_pd(z01, z23))} -
           ray.origin;
  };
  const Vec3<Floats8> a = corner(&Triangle<float>::a), b = corner(&Triangle<float>::b),
                      c = corner(&Triangle<float>::c);
  return intersect(ray, a, b, c, t);
}

} // namespace masu
