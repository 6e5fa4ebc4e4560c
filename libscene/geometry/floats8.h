// Eight floats side by side, on processors with AVX2 and FMA: a Vec3 of them is eight vectors. Operations are
// those of real.h, lane by lane, with the same bits; so is what templates of other headers make of them. Host
// only.
#pragma once

#include "libscene/geometry/vector.h"

#include <immintrin.h>

#include <cstddef>

namespace masu {

struct Floats8 {
  __m256 v;

  Floats8() = default;
  MASU_ALWAYS_INLINE Floats8(__m256 lanes) : v(lanes) {}
  MASU_ALWAYS_INLINE Floats8(float all) : v(_mm256_set1_ps(all)) {}
  MASU_ALWAYS_INLINE static Floats8 load(const float* eight) { return _mm256_load_ps(eight); } // aligned
  MASU_ALWAYS_INLINE void store(float* eight) const { _mm256_store_ps(eight, v); }

  MASU_ALWAYS_INLINE friend Floats8 operator+(Floats8 a, Floats8 b) { return _mm256_add_ps(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Floats8 operator-(Floats8 a, Floats8 b) { return _mm256_sub_ps(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Floats8 operator*(Floats8 a, Floats8 b) { return _mm256_mul_ps(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Floats8 operator/(Floats8 a, Floats8 b) { return _mm256_div_ps(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Floats8 operator-(Floats8 a) { return -a.v; }
};

// Of a comparison: all bits of a lane, or none.
struct Mask8 {
  __m256 v;

  MASU_ALWAYS_INLINE friend Mask8 operator&(Mask8 a, Mask8 b) { return {_mm256_and_ps(a.v, b.v)}; }
  MASU_ALWAYS_INLINE friend Mask8 operator|(Mask8 a, Mask8 b) { return {_mm256_or_ps(a.v, b.v)}; }
  // a & ~b
  MASU_ALWAYS_INLINE friend Mask8 without(Mask8 a, Mask8 b) { return {_mm256_andnot_ps(b.v, a.v)}; }
  MASU_ALWAYS_INLINE unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_ps(v)); }
};
MASU_ALWAYS_INLINE Mask8 operator<(Floats8 a, Floats8 b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
MASU_ALWAYS_INLINE Mask8 operator<=(Floats8 a, Floats8 b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)};
}
MASU_ALWAYS_INLINE Mask8 operator==(Floats8 a, Floats8 b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_EQ_OQ)};
}
// All bits of the lanes whose bit is set.
MASU_ALWAYS_INLINE Mask8 lanes_of(unsigned bits) {
  const __m256i each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128),
                set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), each);
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(set, each))};
}
MASU_ALWAYS_INLINE Floats8 select(Mask8 where, Floats8 a, Floats8 b) {
  return _mm256_blendv_ps(b.v, a.v, where.v);
}
MASU_ALWAYS_INLINE Vec3<Floats8> select(Mask8 where, const Vec3<Floats8>& a, const Vec3<Floats8>& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}

MASU_ALWAYS_INLINE Floats8 fma(Floats8 a, Floats8 b, Floats8 c) {
  return _mm256_fmadd_ps(a.v, b.v, c.v);
}
MASU_ALWAYS_INLINE Floats8 magnitude(Floats8 a) {
  return _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v);
}
// `b` where `a` is NaN: that is how these instructions are.
MASU_ALWAYS_INLINE Floats8 min(Floats8 a, Floats8 b) {
  return _mm256_min_ps(a.v, b.v);
}
MASU_ALWAYS_INLINE Floats8 max(Floats8 a, Floats8 b) {
  return _mm256_max_ps(a.v, b.v);
}
MASU_ALWAYS_INLINE Floats8 smallest(const Vec3<Floats8>& a) {
  return min(a.x, min(a.y, a.z));
}
MASU_ALWAYS_INLINE Vec3<Floats8> magnitudes(const Vec3<Floats8>& a) {
  return {magnitude(a.x), magnitude(a.y), magnitude(a.z)};
}
MASU_ALWAYS_INLINE Floats8 largest_magnitude(const Vec3<Floats8>& a) {
  const Vec3<Floats8> m = magnitudes(a);
  return max(m.x, max(m.y, m.z));
}
MASU_ALWAYS_INLINE float largest_lane(Floats8 a) {
  __m128 four = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  four = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(four, _mm_movehdup_ps(four)));
}
MASU_ALWAYS_INLINE float least_lane(Floats8 a) {
  return -largest_lane(-a);
}
// Lane i of the result is lane lanes[i] of `v`.
MASU_ALWAYS_INLINE Floats8 permuted(Floats8 v, __m256i lanes) {
  return _mm256_permutevar8x32_ps(v.v, lanes);
}
MASU_ALWAYS_INLINE Vec3<Floats8> all_of(const Vec3<float>& a) {
  return {a.x, a.y, a.z};
}

MASU_ALWAYS_INLINE Floats8 fast_divide(Floats8 a, Floats8 b) {
  const Floats8 one = 1;
  const Floats8 guess =
      _mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(0x7ef311c7), _mm256_castps_si256(b.v)));
  const Floats8 error = fma(-b, guess, one);
  const Floats8 better = fma(fma(error, error, error), guess, guess);
  const Floats8 inverse = fma(fma(-b, better, one), better, better);
  const Floats8 rough = a * inverse;
  return fma(fma(-b, rough, a), inverse, rough);
}
MASU_ALWAYS_INLINE Floats8 finite_inverse(Floats8 v) {
  constexpr float largest = RealTraits<float>::largest;
  return min(max(fast_divide(1, v), -largest), largest);
}
MASU_ALWAYS_INLINE Floats8 inverse_power_of_two(Floats8 magnitude) {
  const __m256i one = _mm256_set1_epi32(1 << 23), most = _mm256_set1_epi32(253 << 23);
  const __m256i power = _mm256_and_si256(_mm256_castps_si256(magnitude.v), _mm256_set1_epi32(0x7f800000));
  const __m256i clamped = _mm256_min_epi32(_mm256_max_epi32(power, one), most);
  return _mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(254 << 23), clamped));
}

// Where they lie in memory: a number of each of eight rays. Not initialised.
struct alignas(32) Numbers8 { // NOLINT(cppcoreguidelines-pro-type-member-init): see above
  float of[8];
  MASU_ALWAYS_INLINE Floats8 all() const { return Floats8::load(of); }
  MASU_ALWAYS_INLINE void set(Floats8 value) { value.store(of); }
};
struct Vectors8 {
  Numbers8 x, y, z;
  MASU_ALWAYS_INLINE Vec3<float> of(std::size_t i) const { return {x.of[i], y.of[i], z.of[i]}; }
  MASU_ALWAYS_INLINE Vec3<Floats8> all() const { return {x.all(), y.all(), z.all()}; }
  MASU_ALWAYS_INLINE void set(const Vec3<Floats8>& value) {
    x.set(value.x);
    y.set(value.y);
    z.set(value.z);
  }
  MASU_ALWAYS_INLINE void set(std::size_t i, const Vec3<float>& value) {
    x.of[i] = value.x;
    y.of[i] = value.y;
    z.of[i] = value.z;
  }
};

} // namespace masu
