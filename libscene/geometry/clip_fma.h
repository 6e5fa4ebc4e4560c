// clip() of clip.h for float32 on processors with AVX2 and FMA: the components side by side, with the same
// operations in the same order, so that it gives the same bits. Host only.
#pragma once

#include "libscene/geometry/box.h"
#include "libscene/geometry/margin.h"
#include "libscene/geometry/ray.h"

#include <immintrin.h>

namespace masu {

// x, y, z, and a lane that doesn't matter.
struct FloatLanes {
  __m128 v;

  MASU_ALWAYS_INLINE static FloatLanes all(float value) { return {_mm_set1_ps(value)}; }
  // Not by a load of four: the vector may just have been stored component by component, for which a load of
  // more would wait.
  MASU_ALWAYS_INLINE static FloatLanes of(const Vec3<float>& a) { return {_mm_setr_ps(a.x, a.y, a.z, 0)}; }
  MASU_ALWAYS_INLINE float x() const { return _mm_cvtss_f32(v); }
  MASU_ALWAYS_INLINE float y() const { return _mm_cvtss_f32(_mm_movehdup_ps(v)); }
  MASU_ALWAYS_INLINE float z() const { return _mm_cvtss_f32(_mm_movehl_ps(v, v)); }
  MASU_ALWAYS_INLINE friend FloatLanes operator-(FloatLanes a, FloatLanes b) {
    return {_mm_sub_ps(a.v, b.v)};
  }
  MASU_ALWAYS_INLINE friend FloatLanes operator*(FloatLanes a, FloatLanes b) {
    return {_mm_mul_ps(a.v, b.v)};
  }
};
MASU_ALWAYS_INLINE FloatLanes fma(FloatLanes a, FloatLanes b, FloatLanes c) {
  return {_mm_fmadd_ps(a.v, b.v, c.v)};
}
MASU_ALWAYS_INLINE FloatLanes minus_product(FloatLanes a, FloatLanes b, FloatLanes c) { // c - a·b
  return {_mm_fnmadd_ps(a.v, b.v, c.v)};
}
// As min() and max() of real.h, NaN included.
MASU_ALWAYS_INLINE FloatLanes min(FloatLanes a, FloatLanes b) {
  return {_mm_min_ps(a.v, b.v)};
}
MASU_ALWAYS_INLINE FloatLanes max(FloatLanes a, FloatLanes b) {
  return {_mm_max_ps(a.v, b.v)};
}
MASU_ALWAYS_INLINE FloatLanes magnitude(FloatLanes a) {
  return {_mm_andnot_ps(_mm_set1_ps(-0.0F), a.v)};
}

// fast_divide() of real.h.
MASU_ALWAYS_INLINE FloatLanes fast_divide(FloatLanes a, FloatLanes b) {
  const FloatLanes one = FloatLanes::all(1);
  const FloatLanes guess{_mm_castsi128_ps(_mm_sub_epi32(_mm_set1_epi32(0x7ef311c7), _mm_castps_si128(b.v)))};
  const FloatLanes error = minus_product(b, guess, one);
  const FloatLanes better = fma(fma(error, error, error), guess, guess);
  const FloatLanes inverse = fma(minus_product(b, better, one), better, better);
  const FloatLanes rough = a * inverse;
  return fma(minus_product(b, rough, a), inverse, rough);
}

MASU_ALWAYS_INLINE bool clip(const Ray<float>& ray, const Box<float>& box, ClippedRay<float>& clipped) {
  using Lanes = FloatLanes;
  constexpr float unit = RealTraits<float>::unit_roundoff, limit = RealTraits<float>::largest;
  const Lanes direction = Lanes::of(ray.direction);
  const Lanes low = Lanes::of(box.min), high = Lanes::of(box.max);
  Lanes origin = Lanes::of(ray.origin);
  float t_min = ray.t_min, t_max = ray.t_max;

  const Lanes sides = max(magnitude(low), magnitude(high)), along = magnitude(direction);
  const float largest = max(sides.x(), max(sides.y(), sides.z()));
  // departs()
  constexpr float padding = (2 * margin_roundings - 16) * unit;
  const Lanes left{
      _mm_blendv_ps((origin - low).v, (high - origin).v, _mm_cmpgt_ps(direction.v, _mm_setzero_ps()))};
  if (min(left.x(), min(left.y(), left.z())) < padding * largest) return false;

  const Lanes inverse =
      min(max(fast_divide(Lanes::all(1), direction), Lanes::all(-limit)), Lanes::all(limit));
  float skipped = 0;
  for (bool again = true; again;) {
    // crosses()
    constexpr float slack = 8 * unit;
    const Lanes t0 = (low - origin) * inverse, t1 = (high - origin) * inverse;
    const Lanes first = min(t0, t1), last = max(t0, t1);
    const float from = max(max(0.0F, first.x()), max(first.y(), first.z()));
    const float leave = min(last.x(), min(last.y(), last.z()));
    const float enter = max(t_min, from * (1 - slack));
    if (!((enter <= leave * (1 + slack)) & (enter <= t_max))) return false;
    origin = fma(direction, Lanes::all(enter), origin);
    again = skipped == 0 && enter * max(along.x(), max(along.y(), along.z())) > 256 * largest;
    skipped += enter;
    t_max -= enter;
    t_min = 0;
  }
  clipped.ray = {{origin.x(), origin.y(), origin.z()}, 0, ray.direction, t_max};
  clipped.inverse = {inverse.x(), inverse.y(), inverse.z()};
  clipped.skipped = skipped;
  return true;
}

} // namespace masu
