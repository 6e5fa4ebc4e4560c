// The primitives a ray can meet, as they stand in the scene file and in GPU memory, and what says which
// object and material each belongs to.
//
// A primitive's number: triangles first, then spheres, then cones, each kind in the NFF's order.
#pragma once

#include "libscene/geometry/box.h"

namespace masu {

using PrimitiveIndex = std::uint32_t;
inline constexpr PrimitiveIndex no_primitive = 0xffffffffU;

// What a primitive belongs to: `object` counts the NFF's objects in its order, `material` the scene's
// materials.
struct Surface {
  std::uint32_t object;
  std::uint32_t material;
};

inline constexpr std::uint32_t no_normals = 0xffffffffU;

// Stored holds the coordinates; a tag fills each vertex up to a 16-byte (float) or 32-byte (double) load.
template <class Stored>
struct TagOf;
template <>
struct TagOf<float> {
  using type = std::uint32_t;
};
template <>
struct TagOf<double> {
  using type = std::uint64_t;
};

// Its front is where a, b, c run counter-clockwise. `normals` is a place in the scene's corner normals, or
// no_normals when it is flat.
template <class Stored>
struct alignas(16) Triangle {
  using Tag = typename TagOf<Stored>::type;
  Vec3<Stored> a;
  Tag object;
  Vec3<Stored> b;
  Tag material;
  Vec3<Stored> c;
  Tag normals;
};

// The shell. A negative radius shows only the inside.
template <class Stored>
struct alignas(16) Sphere {
  Vec3<Stored> center;
  Stored radius;
};

// The side of a cone cut off at both ends, without caps; a cylinder when the radii are equal. Both radii
// negative: only the inside shows. One of them may be zero.
template <class Stored>
struct alignas(16) Cone {
  Vec3<Stored> base;
  Stored base_radius;
  Vec3<Stored> apex;
  Stored apex_radius;
};

// The normals at a smooth triangle's corners, of any length but zero: as a `pp` gives them, or those of the
// surface that the triangle stands for. Triangles may share them.
template <class Stored>
struct CornerNormals {
  Vec3<Stored> a, b, c;
};

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

// The same in double, which holds either store exactly.
template <class T>
MASU_HD inline Triangle<double> widened(const Triangle<T>& t) {
  return {cast<double>(t.a), t.object, cast<double>(t.b), t.material, cast<double>(t.c), t.normals};
}
template <class T>
MASU_HD inline Sphere<double> widened(const Sphere<T>& s) {
  return {cast<double>(s.center), static_cast<double>(s.radius)};
}
template <class T>
MASU_HD inline Cone<double> widened(const Cone<T>& c) {
  return {cast<double>(c.base), static_cast<double>(c.base_radius), cast<double>(c.apex),
          static_cast<double>(c.apex_radius)};
}

} // namespace masu
