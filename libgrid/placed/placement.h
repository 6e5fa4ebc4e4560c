// A mesh placed in the world by a transform, and a ray carried into the mesh's own space.
//
// Triangles are tested in the world, between vertices transformed as they are tested: so hits are, to the
// bit, those of a scene of these vertices. Boxes are tested in the mesh's space, by the ray carried there by
// the inverse, and with planes moved outwards by a bound on all that differs. t is the same in both.
//
// Coordinates in the world are relative to the scene's origin. A transform M v + t is rounded to the store,
// t after the origin is taken from it, and so is what it makes of a vertex, by three fmas in the store's
// arithmetic: as far from what was asked for as a few roundings of |M| |v| and t, as v is.
//
// The bound. Let N be the inverse of M as it is stored, u the unit roundoff of the store, R the largest
// magnitude of the box that rays are clipped to, |.| taken by component; o and d the clipped ray, so that
// |o|, and |p| of each point p = o + s d of it in the box, are at most 1.01 R (clip.h), and |s d| at most
// 2.02 R. A point p with a hit is carried to N (p - t). How far, along each axis of the mesh's space, what is
// computed may be from the mesh's surface:
//  - p lies within 113 u R of the triangle that is tested (margin.h): 113 u |N| R.
//  - Its corners are M v + t but for three roundings: 3.01 u |N| (|M| |v| + |t|).
//  - N (M v + t - t) is v but for E v, where E = N M - 1, off by less than 5 w |N| |M| when it is computed in
//    double, of unit roundoff w.
//  - The ray's origin is carried as N (o - t), in no less than the store's arithmetic: the difference and
//    three fmas are rounded, 4.01 u S, with S = |N| (1.01 R + |t|). Where it is moved instead of the planes,
//    and rounded to the store (placed_lanes_avx2.h), that is 2.02 u S more, and as much of the padding.
//  - Its direction is carried as N d: 3.01 u · 2.02 |N| R.
//  - The distance of a plane is off by less than 9 u times that of the plane from the origin (boxes.h, where
//    the inverse of a direction is rounded once; here it may be off by an ulp), which is less than S and the
//    mesh's largest coordinate: 9 u S, and for the latter there is the margin in the mesh's own boxes.
// In all less than 128 u |N| R + 16 u S + 4 u |N| (|M| |v| + |t|) + (|E| + 5 w |N| |M|) |v|. Moving a plane
// is another rounding as of the plane's distance, for which boxes have a slack of 2^-6 units: now 4 · 2^-9
// are used of it. A factor of 1.01 is for roundings of the bound itself. Planes along all axes are moved
// by the largest of the three.
#pragma once

#include "libgrid/hierarchy/hierarchy.h"
#include "libscene/geometry/clip.h"
#include "libscene/local_origin.h"

#include <bit>

namespace masu {

// Rows of M, and t as the last column: as it was asked for, in the world.
struct Transform {
  double rows[3][4];
};

// Where placements are now: 12 numbers each, M and t by rows as Transform has them, in host memory or a
// GPU's.
struct PlacementMoves {
  const float* floats = nullptr; // or
  const double* doubles = nullptr;
  std::size_t count = 0;
  const std::uint32_t* indices = nullptr; // of each the placement's number; null: of all, in their order
  bool are_square = false;                // 16 numbers each: with a last row of 0 0 0 1, which isn't read

  MASU_HD unsigned numbers() const { return are_square ? 16 : 12; }
};
template <class Transforms>
PlacementMoves moves_of(const Transforms& all) {
  return {.doubles = reinterpret_cast<const double*>(all.data()), .count = all.size()};
}

// A transform as it is stored, and what is computed of it once. `world` and `mask`: which rays see it.
template <class Stored>
struct alignas(16) Placement {
  Stored rows[3][4]; // of M, and t, relative to the scene's origin
  std::uint32_t first_triangle;
  std::uint32_t root; // of its mesh's nodes
  float padding;      // of planes, as above
  std::uint32_t mask;
  Stored inverse[3][3]; // of M
  std::uint32_t mesh, world, reserved;

  MASU_HD Vec3<Stored> translation() const { return {rows[0][3], rows[1][3], rows[2][3]}; }
};
static_assert(sizeof(Placement<float>) == 112 && sizeof(Placement<double>) == 208);

// A node without boxes of the hierarchies above placements (upper_passes.h): an item, a placement or what
// stands beside them, with what a ray needs to enter a placement's mesh. In float64 there is no room for
// that.
struct alignas(16) ItemNode {
  float shift[3];
  std::uint32_t no_boxes; // 0
  std::uint32_t root, item;
  std::uint32_t no_slots[2]; // 0
  float inverse[3][3];
  float padding;
  std::uint32_t mask, reserved;

  MASU_HD Vec3<float> translation() const { return {shift[0], shift[1], shift[2]}; }
};
static_assert(sizeof(ItemNode) == sizeof(HierarchyNode));

// `placement`: null of what stands beside them.
template <class Stored>
MASU_HD inline HierarchyNode item_node(std::uint32_t item, const Placement<Stored>* placement) {
  ItemNode node{};
  node.item = item;
  if constexpr (std::is_same_v<Stored, float>)
    if (placement != nullptr) {
      node.root = placement->root;
      node.padding = placement->padding;
      node.mask = placement->mask;
      for (int k = 0; k < 3; ++k) {
        node.shift[k] = placement->rows[k][3];
        for (int j = 0; j < 3; ++j)
          node.inverse[k][j] = placement->inverse[k][j];
      }
    }
  return std::bit_cast<HierarchyNode>(node);
}

// M v + t: of each coordinate fma(M0, x, fma(M1, y, fma(M2, z, t))).
template <class Stored> // or as many side by side as lanes
MASU_HD inline Stored along(const Stored (&row)[4], const Vec3<Stored>& v) {
  return fma(row[0], v.x, fma(row[1], v.y, fma(row[2], v.z, row[3])));
}
template <class Stored>
MASU_HD inline Vec3<Stored> to_world(const Placement<Stored>& placement, const Vec3<Stored>& v) {
  return {along(placement.rows[0], v), along(placement.rows[1], v), along(placement.rows[2], v)};
}
// A triangle in the world; object, material and normals stay.
template <class Stored>
MASU_HD inline Triangle<Stored> placed_triangle(const Placement<Stored>& placement,
                                                const Triangle<Stored>& triangle) {
  Triangle<Stored> placed = triangle;
  placed.a = to_world(placement, triangle.a);
  placed.b = to_world(placement, triangle.b);
  placed.c = to_world(placement, triangle.c);
  return placed;
}
// The same of one that a scene of these vertices holds as a point without a surface (has_surface()): where
// two corners have become one.
template <class Stored>
MASU_HD inline Triangle<Stored> placed_surface(const Placement<Stored>& placement,
                                               const Triangle<Stored>& triangle) {
  Triangle<Stored> placed = placed_triangle(placement, triangle);
  if (placed.a == placed.b || placed.b == placed.c || placed.c == placed.a) placed.b = placed.c = placed.a;
  return placed;
}

// Of a vector in the world, by the inverse.
template <class Placed, class Real>
MASU_ALWAYS_INLINE Vec3<Real> carried(const Placed& placement, const Vec3<Real>& v) {
  const auto along = [&](const auto(&row)[3]) {
    return fma(static_cast<Real>(row[0]), v.x,
               fma(static_cast<Real>(row[1]), v.y, static_cast<Real>(row[2]) * v.z));
  };
  return {along(placement.inverse[0]), along(placement.inverse[1]), along(placement.inverse[2])};
}
// Of a point.
template <class Placed, class Real>
MASU_ALWAYS_INLINE Vec3<Real> carried_point(const Placed& placement, const Vec3<Real>& point) {
  return carried(placement, point - cast<Real>(placement.translation()));
}

// Of a matrix's rows the sums of the magnitudes of their products with a vector that isn't negative.
template <class Stored, int columns>
MASU_HD inline Vec3d magnitudes_times(const Stored (&rows)[3][columns], const Vec3d& v) {
  const auto along = [&](const Stored(&row)[columns]) {
    return std::abs(double{row[0]}) * v.x + std::abs(double{row[1]}) * v.y + std::abs(double{row[2]}) * v.z;
  };
  return {along(rows[0]), along(rows[1]), along(rows[2])};
}
MASU_HD inline Vec3d magnitudes(const Vec3d& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

// How far apart coordinates in both spaces may be scaled, and how far away a carried origin may be: far
// enough from where products with inverses (boxes.h) would overflow.
inline constexpr double max_placed_scale = 0x1p40, max_carried = 0x1p62;
inline constexpr float too_far = INFINITY; // as a padding

inline constexpr const char* not_invertible =
    "can't be inverted: its transform is singular, not finite, or scales by more than 2^40";

// Fills in the transform and its inverse. False where there is no inverse, a number isn't finite, or scales
// are beyond max_placed_scale.
template <class Stored>
MASU_HD inline bool set_transform(const Vec3d& origin, const Transform& transform,
                                  Placement<Stored>& placement) {
  double m[3][3];
  bool is_sound = true;
  const Vec3d t{transform.rows[0][3], transform.rows[1][3], transform.rows[2][3]};
  const Vec3d local = relative_to(origin, t);
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      placement.rows[k][j] = static_cast<Stored>(transform.rows[k][j]);
      m[k][j] = double{placement.rows[k][j]};
      is_sound = is_sound && std::abs(m[k][j]) <= max_placed_scale;
    }
    placement.rows[k][3] = static_cast<Stored>(local[k]);
  }
  const Vec3d x{m[0][0], m[0][1], m[0][2]}, y{m[1][0], m[1][1], m[1][2]}, z{m[2][0], m[2][1], m[2][2]};
  const Vec3d columns[3] = {cross(y, z), cross(z, x), cross(x, y)};
  const double of_determinant = 1 / dot(x, columns[0]);
  for (int k = 0; k < 3; ++k) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) {
      placement.inverse[k][j] = static_cast<Stored>(columns[j][k] * of_determinant);
      sum += std::abs(double{placement.inverse[k][j]});
    }
    is_sound = is_sound && sum >= 1 / max_placed_scale && sum <= max_placed_scale; // of NaN neither
  }
  return is_sound && is_coordinate(t) && is_coordinate(local);
}

// Fills in the padding for rays clipped to what is no farther than `reach` from the origin. `extent`: the
// largest magnitudes of the mesh's coordinates. False, and too_far, where it would be too large.
template <class Stored>
MASU_HD inline bool pad(const Vec3d& extent, double reach, Placement<Stored>& placement) {
  constexpr auto u = static_cast<double>(RealTraits<Stored>::unit_roundoff);
  constexpr double w = RealTraits<double>::unit_roundoff;
  const auto& m = placement.rows;
  const auto& n = placement.inverse;
  const Vec3d t = magnitudes(cast<double>(placement.translation())), all{reach, reach, reach};
  const Vec3d of_reach = magnitudes_times(n, all), of_origin = magnitudes_times(n, all * 1.01 + t),
              of_corners = magnitudes_times(n, magnitudes_times(m, extent) + t);
  placement.padding = too_far;
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    double of_inverse = 0;
    for (int l = 0; l < 3; ++l) {
      double product = k == l ? -1 : 0, size = 0;
      for (int j = 0; j < 3; ++j) {
        product = fma(double{n[k][j]}, double{m[j][l]}, product);
        size += std::abs(double{n[k][j]} * double{m[j][l]});
      }
      of_inverse += (std::abs(product) + 5 * w * size) * extent[l];
    }
    const double sum = 128 * u * of_reach[k] + 16 * u * of_origin[k] + 4 * u * of_corners[k] + of_inverse;
    if (!(of_origin[k] <= max_carried && sum <= max_carried)) return false;
    most = max(most, sum);
  }
  placement.padding = rounded_up(1.01 * most);
  return true;
}

// The box in the world around what a box of the mesh's holds. Each fma rises or falls with each coordinate,
// rounded or not: so corners of the box have the least and the greatest coordinates that a vertex in it may
// get.
template <class Stored>
MASU_HD inline Box<Stored> placed_box(const Placement<Stored>& placement, const Box<Stored>& box) {
  Box<Stored> placed{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto& row = placement.rows[axis];
    const Vec3<Stored> least{row[0] < 0 ? box.max.x : box.min.x, row[1] < 0 ? box.max.y : box.min.y,
                             row[2] < 0 ? box.max.z : box.min.z},
        greatest{row[0] < 0 ? box.min.x : box.max.x, row[1] < 0 ? box.min.y : box.max.y,
                 row[2] < 0 ? box.min.z : box.max.z};
    placed.min.set(axis, along(row, least));
    placed.max.set(axis, along(row, greatest));
  }
  return placed;
}

} // namespace masu
