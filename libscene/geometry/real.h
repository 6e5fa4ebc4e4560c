// What the arithmetic needs to know of its floating-point type, and products that keep their digits.
#pragma once

#include "libscene/portable.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace masu {

// unit_roundoff: half the distance from 1 to the next number: the relative error of one rounding.
// largest: the far end of every ray that has none.
template <class Real>
struct RealTraits;
template <>
struct RealTraits<float> {
  static constexpr float unit_roundoff = 5.9604644775390625e-8F;
  static constexpr float largest = 3.402823466e38F;
  static constexpr float smallest_normal = 1.17549435e-38F;
};
template <>
struct RealTraits<double> {
  static constexpr double unit_roundoff = 1.1102230246251565e-16;
  static constexpr double largest = 1.7976931348623157e308;
  static constexpr double smallest_normal = 2.2250738585072014e-308;
};

// a*b + c, rounded once.
MASU_SMALL float fma(float a, float b, float c) {
  return std::fma(a, b, c);
}
MASU_SMALL double fma(double a, double b, double c) {
  return std::fma(a, b, c);
}

// a*b - c*d to within 1.5 ulp of the result, whatever cancels, so that its sign is exact short of underflow.
// Kahan's algorithm; the bound is by Jeannerod, Louvet & Muller, Mathematics of Computation 82(284), 2013.
template <class Real>
MASU_SMALL Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Real cd = c * d;
  const Real lost = fma(-c, d, cd);
  return fma(a, b, -cd) + lost;
}

// A number's bits, and back.
MASU_SMALL std::uint32_t bits_of(float value) {
#ifdef __CUDA_ARCH__
  return __float_as_uint(value);
#else
  return std::bit_cast<std::uint32_t>(value);
#endif
}
MASU_SMALL float float_of(std::uint32_t bits) {
#ifdef __CUDA_ARCH__
  return __uint_as_float(bits);
#else
  return std::bit_cast<float>(bits);
#endif
}
MASU_SMALL std::uint64_t bits_of(double value) {
#ifdef __CUDA_ARCH__
  return static_cast<std::uint64_t>(__double_as_longlong(value));
#else
  return std::bit_cast<std::uint64_t>(value);
#endif
}
MASU_SMALL double double_of(std::uint64_t bits) {
#ifdef __CUDA_ARCH__
  return __longlong_as_double(static_cast<long long>(bits));
#else
  return std::bit_cast<double>(bits);
#endif
}

// a / b, for |b| from 2^-126 to 2^125 and while what it leaves is a normal number: rounded as division is, or
// once in a hundred thousand to the number beside; beyond, whatever it is, the same on host and device.
// Without a branch, where the device's own division has a slow path that costs all code around it registers.
// Newton's iteration, from a guess by the exponent.
MASU_SMALL float fast_divide(float a, float b) {
  const float guess = float_of(0x7ef311c7U - bits_of(b)); // off by up to an eighth
  const float lacks = fma(-b, guess, 1.0F);
  const float better = fma(fma(lacks, lacks, lacks), guess, guess);
  const float inverse = fma(fma(-b, better, 1.0F), better, better);
  const float rough = a * inverse;
  return fma(fma(-b, rough, a), inverse, rough);
}
MASU_SMALL double fast_divide(double a, double b) {
  return a / b;
}

// The smaller and the larger of two numbers, spelled out so that host and device agree on NaN: it never wins
// over `b`.
template <class T>
MASU_SMALL T min(T a, T b) {
  return a < b ? a : b;
}
template <class T>
MASU_SMALL T max(T a, T b) {
  return a > b ? a : b;
}

// 1 / v for |v| up to 2^125, never infinite, so that no product with a distance of 0 is NaN: where it would
// be, the largest number, of either sign.
template <class Real>
MASU_SMALL Real finite_inverse(Real v) {
  constexpr Real largest = RealTraits<Real>::largest;
  return min(max(fast_divide(Real(1), v), -largest), largest); // of 0 the quotient is NaN
}

// Rounded towards zero; beyond 2^30, where nothing here depends on it, to a number as large or
// larger; NaN to 0 (as the device's own conversion has it).
MASU_SMALL std::int32_t truncated(float v) {
#ifdef __CUDA_ARCH__
  return __float2int_rz(v);
#else
  constexpr float most = 0x1p30F;
  return v != v ? 0 : static_cast<std::int32_t>(v < -most ? -most : v > most ? most : v);
#endif
}
MASU_SMALL std::int32_t truncated(double v) {
#ifdef __CUDA_ARCH__
  return __double2int_rz(v);
#else
  constexpr double most = 0x1p30;
  return v != v ? 0 : static_cast<std::int32_t>(v < -most ? -most : v > most ? most : v);
#endif
}

// 2^-e for a number of magnitude 2^e to 2^(e+1); the nearest power that is a normal number.
MASU_SMALL float inverse_power_of_two(float magnitude) {
  constexpr std::int32_t one = 1 << 23; // of the exponent
  const auto power = static_cast<std::int32_t>(bits_of(magnitude) & 0x7f800000U);
  return float_of(static_cast<std::uint32_t>(254 * one - (power < one         ? one
                                                          : power > 253 * one ? 253 * one
                                                                              : power)));
}

MASU_SMALL double inverse_power_of_two(double magnitude) {
  const auto exponent = static_cast<std::int64_t>(bits_of(magnitude) >> 52 & 0x7ff);
  const std::int64_t inverse = 2046 - (exponent < 1 ? 1 : exponent > 2045 ? 2045 : exponent);
  return double_of(static_cast<std::uint64_t>(inverse) << 52);
}

// The least and the greatest of numbers that are never NaN, in one instruction; of -0 and +0 either.
MASU_SMALL float fast_min(float a, float b) {
#ifdef __CUDA_ARCH__
  return fminf(a, b);
#else
  return min(a, b);
#endif
}
MASU_SMALL float fast_max(float a, float b) {
#ifdef __CUDA_ARCH__
  return fmaxf(a, b);
#else
  return max(a, b);
#endif
}
MASU_SMALL double fast_min(double a, double b) {
  return min(a, b);
}
MASU_SMALL double fast_max(double a, double b) {
  return max(a, b);
}

} // namespace masu
