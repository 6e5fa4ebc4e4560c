// A closed axis-aligned box: its faces belong to it.
#pragma once

#include "libscene/geometry/vector.h"

namespace masu {

template <class T>
struct Box {
  Vec3<T> min, max;
};

using Boxf = Box<float>;
using Boxd = Box<double>;

// Contains nothing; the neutral element of join.
template <class T>
MASU_HD inline Box<T> empty_box() {
  const T far = RealTraits<T>::largest;
  return {{far, far, far}, {-far, -far, -far}};
}
template <class T>
MASU_HD inline bool is_empty(const Box<T>& b) {
  return !(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z);
}
template <class T>
MASU_HD inline Box<T> join(const Box<T>& a, const Box<T>& b) {
  return {{min(a.min.x, b.min.x), min(a.min.y, b.min.y), min(a.min.z, b.min.z)},
          {max(a.max.x, b.max.x), max(a.max.y, b.max.y), max(a.max.z, b.max.z)}};
}
template <class T>
MASU_HD inline Box<T> join(const Box<T>& a, const Vec3<T>& p) {
  return join(a, Box<T>{p, p});
}
template <class T>
MASU_HD inline Box<T> bounds(const Box<T>& b) {
  return b;
}
template <class T>
MASU_HD inline Box<T> grown(const Box<T>& b, T by) {
  return {b.min - Vec3<T>{by, by, by}, b.max + Vec3<T>{by, by, by}};
}
template <class T>
MASU_HD inline bool contains(const Box<T>& b, const Vec3<T>& p) {
  return p.x >= b.min.x && p.x <= b.max.x && p.y >= b.min.y && p.y <= b.max.y && p.z >= b.min.z &&
         p.z <= b.max.z;
}
template <class To, class From>
MASU_HD inline Box<To> cast(const Box<From>& b) {
  return {cast<To>(b.min), cast<To>(b.max)};
}
template <class T>
MASU_HD inline T largest_magnitude(const Box<T>& b) {
  return max(largest_magnitude(b.min), largest_magnitude(b.max));
}

} // namespace masu
