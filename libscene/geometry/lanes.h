// Numbers side by side in a register of a processor with AVX2 and FMA: eight floats, or four doubles. A Vec3
// of them is as many vectors. Operations are those of real.h, lane by lane, with the same bits; so is what
// templates of other headers make of them. Host only.
#pragma once

#include "libscene/geometry/vector.h"

#include <immintrin.h>

#include <cstddef>

namespace masu {

// Where an instruction has a name for each type.
namespace avx2 {

MASU_ALWAYS_INLINE __m256 all(float v) {
  return _mm256_set1_ps(v);
}
MASU_ALWAYS_INLINE __m256d all(double v) {
  return _mm256_set1_pd(v);
}
MASU_ALWAYS_INLINE __m256 fma(__m256 a, __m256 b, __m256 c) {
  return _mm256_fmadd_ps(a, b, c);
}
MASU_ALWAYS_INLINE __m256d fma(__m256d a, __m256d b, __m256d c) {
  return _mm256_fmadd_pd(a, b, c);
}
MASU_ALWAYS_INLINE __m256 min(__m256 a, __m256 b) {
  return _mm256_min_ps(a, b);
}
MASU_ALWAYS_INLINE __m256d min(__m256d a, __m256d b) {
  return _mm256_min_pd(a, b);
}
MASU_ALWAYS_INLINE __m256 max(__m256 a, __m256 b) {
  return _mm256_max_ps(a, b);
}
MASU_ALWAYS_INLINE __m256d max(__m256d a, __m256d b) {
  return _mm256_max_pd(a, b);
}
MASU_ALWAYS_INLINE __m256 blend(__m256 a, __m256 b, __m256 where) {
  return _mm256_blendv_ps(a, b, where);
}
MASU_ALWAYS_INLINE __m256d blend(__m256d a, __m256d b, __m256d where) {
  return _mm256_blendv_pd(a, b, where);
}
MASU_ALWAYS_INLINE int signs(__m256 v) {
  return _mm256_movemask_ps(v);
}
MASU_ALWAYS_INLINE int signs(__m256d v) {
  return _mm256_movemask_pd(v);
}

} // namespace avx2

// Of a comparison: all bits of a lane, or none.
template <class Real>
struct LaneMask {
  using Register = decltype(avx2::all(Real()));
  Register v;

  MASU_ALWAYS_INLINE explicit LaneMask(Register lanes) : v(lanes) {}
  MASU_ALWAYS_INLINE explicit LaneMask(__m256i lanes) : v(reinterpret_cast<Register>(lanes)) {}
  MASU_ALWAYS_INLINE __m256i whole() const { return reinterpret_cast<__m256i>(v); }
  MASU_ALWAYS_INLINE unsigned bits() const { return static_cast<unsigned>(avx2::signs(v)); }

  MASU_ALWAYS_INLINE friend LaneMask operator&(LaneMask a, LaneMask b) {
    return LaneMask(a.whole() & b.whole());
  }
  MASU_ALWAYS_INLINE friend LaneMask operator|(LaneMask a, LaneMask b) {
    return LaneMask(a.whole() | b.whole());
  }
  // a & ~b
  MASU_ALWAYS_INLINE friend LaneMask without(LaneMask a, LaneMask b) {
    return LaneMask(a.whole() & ~b.whole());
  }
};

template <class Real>
struct Lanes {
  using Mask = LaneMask<Real>;
  using Register = typename Mask::Register;
  static constexpr std::size_t count = sizeof(Register) / sizeof(Real);
  Register v;

  Lanes() = default;
  MASU_ALWAYS_INLINE Lanes(Register lanes) : v(lanes) {}
  MASU_ALWAYS_INLINE Lanes(Real all) : v(avx2::all(all)) {}
  MASU_ALWAYS_INLINE static Lanes load(const Real* from) { // aligned
    return *reinterpret_cast<const Register*>(from);
  }
  MASU_ALWAYS_INLINE void store(Real* to) const { *reinterpret_cast<Register*>(to) = v; }
  MASU_ALWAYS_INLINE __m256i whole() const { return reinterpret_cast<__m256i>(v); }

  MASU_ALWAYS_INLINE friend Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  MASU_ALWAYS_INLINE friend Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  MASU_ALWAYS_INLINE friend Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  MASU_ALWAYS_INLINE friend Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  MASU_ALWAYS_INLINE friend Lanes operator-(Lanes a) { return -a.v; }
  MASU_ALWAYS_INLINE friend Mask operator<(Lanes a, Lanes b) { return mask(a.v < b.v); }
  MASU_ALWAYS_INLINE friend Mask operator<=(Lanes a, Lanes b) { return mask(a.v <= b.v); }
  MASU_ALWAYS_INLINE friend Mask operator==(Lanes a, Lanes b) { return mask(a.v == b.v); }

  MASU_ALWAYS_INLINE friend Lanes fma(Lanes a, Lanes b, Lanes c) { return avx2::fma(a.v, b.v, c.v); }
  // `b` where `a` is NaN: that is how these instructions are.
  MASU_ALWAYS_INLINE friend Lanes min(Lanes a, Lanes b) { return avx2::min(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Lanes max(Lanes a, Lanes b) { return avx2::max(a.v, b.v); }
  MASU_ALWAYS_INLINE friend Lanes select(Mask where, Lanes a, Lanes b) {
    return avx2::blend(b.v, a.v, where.v);
  }
  MASU_ALWAYS_INLINE friend Lanes magnitude(Lanes a) {
    return reinterpret_cast<Register>(a.whole() & ~Lanes(Real(-0.0)).whole());
  }
  MASU_ALWAYS_INLINE friend Lanes finite_inverse(Lanes a) {
    constexpr Real largest = RealTraits<Real>::largest;
    return min(max(fast_divide(Lanes(1), a), -largest), largest);
  }

private:
  MASU_ALWAYS_INLINE static Mask mask(auto whole) { return Mask(reinterpret_cast<Register>(whole)); }
};
using Floats8 = Lanes<float>;
using Doubles4 = Lanes<double>;

template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> all_of(const Vec3<Real>& a) {
  return {a.x, a.y, a.z};
}
template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> select(LaneMask<Real> where, const Vec3<Lanes<Real>>& a,
                                            const Vec3<Lanes<Real>>& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}
template <class Real>
MASU_ALWAYS_INLINE Lanes<Real> smallest(const Vec3<Lanes<Real>>& a) {
  return min(a.x, min(a.y, a.z));
}
template <class Real>
MASU_ALWAYS_INLINE Vec3<Lanes<Real>> magnitudes(const Vec3<Lanes<Real>>& a) {
  return {magnitude(a.x), magnitude(a.y), magnitude(a.z)};
}
template <class Real>
MASU_ALWAYS_INLINE Lanes<Real> largest_magnitude(const Vec3<Lanes<Real>>& a) {
  const Vec3<Lanes<Real>> m = magnitudes(a);
  return max(m.x, max(m.y, m.z));
}

MASU_ALWAYS_INLINE float largest_lane(Floats8 a) {
  __m128 four = _mm_max_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  four = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(four, _mm_movehdup_ps(four)));
}
MASU_ALWAYS_INLINE double largest_lane(Doubles4 a) {
  const __m128d two = _mm_max_pd(_mm256_castpd256_pd128(a.v), _mm256_extractf128_pd(a.v, 1));
  return _mm_cvtsd_f64(_mm_max_sd(two, _mm_unpackhi_pd(two, two)));
}
template <class Real>
MASU_ALWAYS_INLINE Real least_lane(Lanes<Real> a) {
  return -largest_lane(-a);
}

// The four first floats of the first, the others of the second.
MASU_ALWAYS_INLINE Floats8 rounded_up(Doubles4 first, Doubles4 second) {
  const __m128 low = _mm256_cvtpd_ps(first.v), high = _mm256_cvtpd_ps(second.v);
  const __m256 nearest = _mm256_set_m128(high, low);
  const auto is_less = [](__m128 rounded, Doubles4 value) {
    return _mm256_castpd_ps((Doubles4(_mm256_cvtps_pd(rounded)) < value).v);
  };
  const __m256 halves = _mm256_shuffle_ps(is_less(low, first), is_less(high, second), 0b10'00'10'00);
  const __m256d moves = _mm256_permute4x64_pd(_mm256_castps_pd(halves), 0b11'01'10'00);
  // Away from zero if it is positive; and -0 as 0.
  const __m256i bits = _mm256_castps_si256(_mm256_add_ps(nearest, _mm256_setzero_ps()));
  const __m256i step = _mm256_or_si256(_mm256_srai_epi32(bits, 31), _mm256_set1_epi32(1));
  return _mm256_blendv_ps(nearest, _mm256_castsi256_ps(_mm256_add_epi32(bits, step)),
                          _mm256_castpd_ps(moves));
}

// Of eight floats those from `first` on.
template <class Real>
MASU_ALWAYS_INLINE Lanes<Real> part_of(Floats8 eight, std::size_t first) {
  if constexpr (sizeof(Real) == sizeof(float))
    return eight;
  else
    return _mm256_cvtps_pd(first == 0 ? _mm256_castps256_ps128(eight.v) : _mm256_extractf128_ps(eight.v, 1));
}

// Four doubles as the first of eight floats, before zeros; or as they are.
template <class To, class From>
MASU_ALWAYS_INLINE Lanes<To> rounded(Lanes<From> all) {
  if constexpr (sizeof(To) == sizeof(From))
    return all;
  else
    return _mm256_zextps128_ps256(_mm256_cvtpd_ps(all.v));
}

// Whole numbers in lanes as wide as those of Real.
template <class Real>
MASU_ALWAYS_INLINE __m256i whole_in_lanes(unsigned all) {
  return sizeof(Real) == 4 ? _mm256_set1_epi32(static_cast<int>(all)) : _mm256_set1_epi64x(all);
}
template <class Real>
MASU_ALWAYS_INLINE LaneMask<Real> is_greater(__m256i a, __m256i b) {
  return LaneMask<Real>(sizeof(Real) == 4 ? _mm256_cmpgt_epi32(a, b) : _mm256_cmpgt_epi64(a, b));
}
// All bits of the lanes whose bit is set.
template <class Real>
MASU_ALWAYS_INLINE LaneMask<Real> lanes_of(unsigned bits) {
  const __m256i each =
      sizeof(Real) == 4 ? _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128) : _mm256_setr_epi64x(1, 2, 4, 8);
  const __m256i zero = _mm256_setzero_si256();
  return is_greater<Real>(whole_in_lanes<Real>(bits) & each, zero);
}

// Lane i of the result is lane lanes[i] of `v`.
MASU_ALWAYS_INLINE Floats8 permuted(Floats8 v, __m256i lanes) {
  return _mm256_permutevar8x32_ps(v.v, lanes);
}
// One lane in all.
template <int lane>
MASU_ALWAYS_INLINE Floats8 broadcast(Floats8 v) {
  return permuted(v, _mm256_set1_epi32(lane));
}
template <int lane>
MASU_ALWAYS_INLINE Doubles4 broadcast(Doubles4 v) {
  return _mm256_permute4x64_pd(v.v, lane * 0x55);
}

MASU_ALWAYS_INLINE Doubles4 fast_divide(Doubles4 a, Doubles4 b) {
  return a / b;
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

// Where they lie in memory: a number of each of several rays. Not initialised.
template <class Real, std::size_t count>
struct alignas(32) Numbers { // NOLINT(cppcoreguidelines-pro-type-member-init): see above
  Real of[count];
  MASU_ALWAYS_INLINE Lanes<Real> all() const requires(count == Lanes<Real>::count) {
    return Lanes<Real>::load(of);
  }
  MASU_ALWAYS_INLINE void set(Lanes<Real> value) requires(count == Lanes<Real>::count) { value.store(of); }
  // Of the rays lanes[0], lanes[1] and so on of eight.
  MASU_ALWAYS_INLINE Lanes<Real> of_rays(const int* lanes) const requires(count == 8) {
    if constexpr (sizeof(Real) == sizeof(float)) {
      return permuted(all(), _mm256_loadu_si256(reinterpret_cast<const __m256i*>(lanes)));
    } else {
      return _mm256_setr_pd(of[lanes[0]], of[lanes[1]], of[lanes[2]], of[lanes[3]]);
    }
  }
};
template <class Real, std::size_t count>
struct Vectors {
  Numbers<Real, count> x, y, z;
  MASU_ALWAYS_INLINE Vec3<Real> of(std::size_t i) const { return {x.of[i], y.of[i], z.of[i]}; }
  MASU_ALWAYS_INLINE Vec3<Lanes<Real>> all() const { return {x.all(), y.all(), z.all()}; }
  MASU_ALWAYS_INLINE Vec3<Lanes<Real>> of_rays(const int* lanes) const {
    return {x.of_rays(lanes), y.of_rays(lanes), z.of_rays(lanes)};
  }
  MASU_ALWAYS_INLINE void set(const Vec3<Lanes<Real>>& value) {
    x.set(value.x);
    y.set(value.y);
    z.set(value.z);
  }
  MASU_ALWAYS_INLINE void set(std::size_t i, const Vec3<Real>& value) {
    x.of[i] = value.x;
    y.of[i] = value.y;
    z.of[i] = value.z;
  }
};

} // namespace masu
