// The records of primitives, the same in the scene file and in GPU memory, with each primitive's object and
// material.
//
// Primitive indices: triangles first, then spheres, then cones, each kind in the NFF's order.
#pragma once

#include "libscene/geometry/box.h"

#include <type_traits>

namespace masu {

using PrimitiveIndex = std::uint32_t;
inline constexpr PrimitiveIndex no_primitive = 0xffffffffU;
// A scene's: what grids can number (libgrid/grid/grid.h).
inline constexpr std::uint64_t max_primitives = 0x7fffffff;

// `object`: index among the NFF's objects, in its order; `material`: index among the scene's materials.
struct Surface {
  std::uint32_t object;
  std::uint32_t material;
};

inline constexpr std::uint32_t no_normals = 0xffffffffU;

// a, b, c are counter-clockwise seen from the front. `normals`: index among the scene's corner normals, or
// no_normals for a flat triangle. Stored: the coordinates' type. A tag pads each vertex to a 16-byte (float)
// or 32-byte (double) load.
template <class Stored>
struct alignas(16) Triangle {
  using Tag = std::conditional_t<sizeof(Stored) == sizeof(float), std::uint32_t, std::uint64_t>;
  Vec3<Stored> a;
  Tag object;
  Vec3<Stored> b;
  Tag material;
  Vec3<Stored> c;
  Tag normals;
};

// The surface only. With a negative radius only the inside is visible.
template <class Stored>
struct alignas(16) Sphere {
  Vec3<Stored> center;
  Stored radius;
};

// The side of a truncated cone, without caps; a cylinder when the radii are equal. With negative radii only
// the inside is visible. One of them may be zero.
template <class Stored>
struct alignas(16) Cone {
  Vec3<Stored> base;
  Stored base_radius;
  Vec3<Stored> apex;
  Stored apex_radius;
};

// The normals at the corners of a smooth triangle, of any length but zero: given by `pp`, or of the surface
// that was tessellated. Triangles may share a record.
template <class Stored>
struct CornerNormals {
  Vec3<Stored> a, b, c;
};

// Whether there is anything to hit. A triangle whose corners are one point has no surface: it keeps the
// number of a face that can't be hit (libscene/mesh/triangle_area.h), and is in no cell.
template <class Stored>
MASU_HD inline bool has_surface(const Triangle<Stored>& t) {
  return !(t.a == t.b && t.b == t.c);
}
template <template <class> class Record, class Stored>
MASU_HD inline bool has_surface(const Record<Stored>&) {
  return true;
}

template <class Stored>
MASU_HD inline bool tapers(const Cone<Stored>& cone) {
  return std::abs(cone.base_radius) != std::abs(cone.apex_radius);
}

static_assert(sizeof(Triangle<float>) == 48 && sizeof(Triangle<double>) == 96);
static_assert(sizeof(Sphere<float>) == 16 && sizeof(Sphere<double>) == 32);
static_assert(sizeof(Cone<float>) == 32 && sizeof(Cone<double>) == 64);
static_assert(sizeof(CornerNormals<float>) == 36 && sizeof(CornerNormals<double>) == 72);
static_assert(sizeof(Surface) == 8);

template <class T>
MASU_HD inline Box<T> bounds(const Triangle<T>& t) {
  return join(join(Box<T>{t.a, t.a}, t.b), t.c);
}
template <class T>
MASU_HD inline Box<T> bounds(const Sphere<T>& s) {
  return grown(Box<T>{s.center, s.center}, std::abs(s.radius));
}

// The same with coordinates of another type.
template <class To, class From>
MASU_HD inline Triangle<To> cast(const Triangle<From>& t) {
  using Tag = typename Triangle<To>::Tag;
  return {cast<To>(t.a), static_cast<Tag>(t.object), cast<To>(t.b), static_cast<Tag>(t.material),
          cast<To>(t.c), static_cast<Tag>(t.normals)};
}
template <class To, class From>
MASU_HD inline Sphere<To> cast(const Sphere<From>& s) {
  return {cast<To>(s.center), static_cast<To>(s.radius)};
}
template <class To, class From>
MASU_HD inline Cone<To> cast(const Cone<From>& c) {
  return {cast<To>(c.base), static_cast<To>(c.base_radius), cast<To>(c.apex), static_cast<To>(c.apex_radius)};
}
template <class To, class From>
MASU_HD inline CornerNormals<To> cast(const CornerNormals<From>& n) {
  return {cast<To>(n.a), cast<To>(n.b), cast<To>(n.c)};
}
// In double, exactly.
template <template <class> class Record, class T>
MASU_HD inline Record<double> widened(const Record<T>& record) {
  return cast<double>(record);
}

} // namespace masu
