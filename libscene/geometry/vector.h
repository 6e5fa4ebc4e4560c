// Points, directions and colours.
#pragma once

#include "libscene/geometry/real.h"

namespace masu {

template <class T>
struct Vec3 {
  T x, y, z;

  MASU_ALWAYS_INLINE T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  MASU_ALWAYS_INLINE void set(int axis, T value) { (axis == 0 ? x : axis == 1 ? y : z) = value; }
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
using Vec3i = Vec3<std::int32_t>;

// Converts each component, rounding to nearest where To is narrower.
template <class To, class From>
MASU_ALWAYS_INLINE Vec3<To> cast(const Vec3<From>& v) {
  return {static_cast<To>(v.x), static_cast<To>(v.y), static_cast<To>(v.z)};
}

template <class T>
MASU_ALWAYS_INLINE Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
MASU_ALWAYS_INLINE Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
MASU_ALWAYS_INLINE Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
MASU_ALWAYS_INLINE Vec3<T> operator*(const Vec3<T>& a, T s) {
  return {a.x * s, a.y * s, a.z * s};
}
// Component by component, as for light and colour.
template <class T>
MASU_ALWAYS_INLINE Vec3<T> operator*(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
MASU_ALWAYS_INLINE bool operator==(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

template <class T>
MASU_ALWAYS_INLINE T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
template <class T>
MASU_ALWAYS_INLINE Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}
// The same with an error of a few roundings of |a||b|, in half the operations.
template <class T>
MASU_ALWAYS_INLINE Vec3<T> rough_cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
}
// b*s + a, each component rounded once.
template <class T>
MASU_ALWAYS_INLINE Vec3<T> fma(const Vec3<T>& b, T s, const Vec3<T>& a) {
  return {fma(b.x, s, a.x), fma(b.y, s, a.y), fma(b.z, s, a.z)};
}
template <class T>
MASU_ALWAYS_INLINE T length(const Vec3<T>& a) {
  return std::sqrt(dot(a, a));
}
// Whether no component is NaN or infinite.
template <class T>
MASU_ALWAYS_INLINE bool is_finite(const Vec3<T>& v) {
  return v - v == Vec3<T>{};
}
// The largest component's magnitude; v must not contain NaN.
template <class T>
MASU_ALWAYS_INLINE T largest_magnitude(const Vec3<T>& v) {
  return fast_max(std::abs(v.x), fast_max(std::abs(v.y), std::abs(v.z)));
}
template <class T>
MASU_ALWAYS_INLINE T sum_of_magnitudes(const Vec3<T>& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}
// Of unit length; v must not be zero. Scaled first, since the square of a large or small v is out of range.
template <class T>
MASU_ALWAYS_INLINE Vec3<T> normalized(const Vec3<T>& v) {
  const Vec3<T> scaled = v * inverse_power_of_two(largest_magnitude(v));
  return scaled * fast_divide(T(1), length(scaled));
}

} // namespace masu
