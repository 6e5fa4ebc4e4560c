// Properties of floating-point types, and arithmetic that gives the same bits on host and device.
#pragma once

#include "libscene/base/portable.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace masu {

// unit_roundoff: the relative error bound of one rounding, half the distance from 1 to the next number.
// largest: also t_max of unbounded rays.
template <class Real>
struct RealTraits;
template <>
struct RealTraits<float> {
  static constexpr float unit_roundoff = 5.9604644775390625e-8F;
  static constexpr float largest = 3.402823466e38F;
};
template <>
struct RealTraits<double> {
  static constexpr double unit_roundoff = 1.1102230246251565e-16;
  static constexpr double largest = 1.7976931348623157e308;
};

// a*b + c, rounded once.
MASU_ALWAYS_INLINE float fma(float a, float b, float c) {
  return std::fma(a, b, c);
}
MASU_ALWAYS_INLINE double fma(double a, double b, double c) {
  return std::fma(a, b, c);
}

// a*b - c*d to within 1.5 ulp of the result despite cancellation; its sign is exact unless it underflows.
// Kahan's algorithm; the bound is by Jeannerod, Louvet & Muller, Mathematics of Computation 82(284), 2013.
template <class Real>
MASU_ALWAYS_INLINE Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Real cd = c * d;
  const Real error = fma(-c, d, cd);
  return fma(a, b, -cd) + error;
}

// A number's bits, and back.
MASU_ALWAYS_INLINE std::uint32_t bits_of(float value) {
  return __builtin_bit_cast(std::uint32_t, value);
}
MASU_ALWAYS_INLINE float float_of(std::uint32_t bits) {
  return __builtin_bit_cast(float, bits);
}
MASU_ALWAYS_INLINE std::uint64_t bits_of(double value) {
  return __builtin_bit_cast(std::uint64_t, value);
}

// The next number above or below one that isn't negative; of 0 there is none below.
template <class Real>
MASU_ALWAYS_INLINE Real next_above(Real value) {
  return __builtin_bit_cast(Real, bits_of(value) + 1);
}
template <class Real>
MASU_ALWAYS_INLINE Real next_below(Real value) {
  return __builtin_bit_cast(Real, bits_of(value) - (value > 0 ? 1 : 0));
}

// a / b for |b| from 2^-126 to 2^125 and a remainder that is a normal number: correctly rounded, but once in
// a hundred thousand off by one ulp. Otherwise inaccurate, but the same on host and device. Newton's
// iteration without a branch; the device's own division has a slow path whose registers slow down the code
// around it.
MASU_ALWAYS_INLINE float fast_divide(float a, float b) {
  const float guess = float_of(0x7ef311c7U - bits_of(b)); // relative error up to 1/8
  const float error = fma(-b, guess, 1.0F);
  const float better = fma(fma(error, error, error), guess, guess);
  const float inverse = fma(fma(-b, better, 1.0F), better, better);
  const float rough = a * inverse;
  return fma(fma(-b, rough, a), inverse, rough);
}
MASU_ALWAYS_INLINE double fast_divide(double a, double b) {
  return a / b;
}

// Minimum and maximum with the same result for NaN on host and device: `b` when `a` is NaN.
template <class T>
MASU_ALWAYS_INLINE T min(T a, T b) {
  return a < b ? a : b;
}
template <class T>
MASU_ALWAYS_INLINE T max(T a, T b) {
  return a > b ? a : b;
}

// 1 / v for |v| up to 2^125, clamped to finite numbers so that its product with a distance of 0 isn't NaN.
// For v = 0 the largest number, of either sign.
template <class Real>
MASU_ALWAYS_INLINE Real finite_inverse(Real v) {
  constexpr Real largest = RealTraits<Real>::largest;
  return min(max(fast_divide(Real(1), v), -largest), largest); // NaN for v = 0
}

// Has the device's compiler keep a number in its register, where it would otherwise compute it again at each
// use.
MASU_ALWAYS_INLINE void keep([[maybe_unused]] float& value) {
#ifdef __CUDA_ARCH__
  asm volatile("" : "+f"(value));
#endif
}
MASU_ALWAYS_INLINE void keep([[maybe_unused]] double& value) {
#ifdef __CUDA_ARCH__
  asm volatile("" : "+d"(value));
#endif
}

// Rounded towards zero. Beyond ±2^30 the result is only known to be at least that large, since the device
// saturates later; NaN gives 0, as on the device.
template <class Real>
MASU_ALWAYS_INLINE std::int32_t truncated(Real v) {
#ifdef __CUDA_ARCH__
  if constexpr (sizeof(Real) == sizeof(float))
    return __float2int_rz(v);
  else
    return __double2int_rz(v);
#else
  constexpr Real limit = 0x1p30F;
  return std::isnan(v) ? 0 : static_cast<std::int32_t>(v < -limit ? -limit : v > limit ? limit : v);
#endif
}

// 2^-e for a magnitude from 2^e to 2^(e+1), clamped to normal numbers.
MASU_ALWAYS_INLINE float inverse_power_of_two(float magnitude) {
  constexpr std::int32_t one = 1 << 23; // 1 in the exponent's bits
  const auto power = static_cast<std::int32_t>(bits_of(magnitude) & 0x7f800000U);
  return float_of(static_cast<std::uint32_t>(254 * one - (power < one         ? one
                                                          : power > 253 * one ? 253 * one
                                                                              : power)));
}

MASU_ALWAYS_INLINE double inverse_power_of_two(double magnitude) {
  const auto exponent = static_cast<std::int64_t>(bits_of(magnitude) >> 52 & 0x7ff);
  const std::int64_t inverse = 2046 - (exponent < 1 ? 1 : exponent > 2045 ? 2045 : exponent);
  return __builtin_bit_cast(double, static_cast<std::uint64_t>(inverse) << 52);
}

// The largest float that isn't above a number, and the smallest that isn't below it. Beyond all floats the
// largest, or infinity; NaN stays.
MASU_ALWAYS_INLINE float rounded_up(double value) {
#ifdef __CUDA_ARCH__
  return __double2float_ru(value);
#else
  const auto nearest = static_cast<float>(value);
  // Away from zero if it is positive. Without a branch: which way a number was rounded can't be predicted.
  const std::uint32_t bits = bits_of(nearest), step = 1 | -(bits >> 31);
  return float_of(bits + step * static_cast<std::uint32_t>(static_cast<double>(nearest) < value));
#endif
}
MASU_ALWAYS_INLINE float rounded_down(double value) {
  return -rounded_up(-value);
}

// Minimum and maximum in one instruction, for numbers that are never NaN; of -0 and +0 either.
MASU_ALWAYS_INLINE float fast_min(float a, float b) {
#ifdef __CUDA_ARCH__
  return fminf(a, b);
#else
  return min(a, b);
#endif
}
MASU_ALWAYS_INLINE float fast_max(float a, float b) {
#ifdef __CUDA_ARCH__
  return fmaxf(a, b);
#else
  return max(a, b);
#endif
}
MASU_ALWAYS_INLINE double fast_min(double a, double b) {
  return min(a, b);
}
MASU_ALWAYS_INLINE double fast_max(double a, double b) {
  return max(a, b);
}

} // namespace masu
