// Affine transforms of an Assimp scene's nodes, in double.
#pragma once

#include "libscene/automatic_camera.h"

#include <assimp/scene.h>

#include <array>
#include <optional>

namespace masu::import {

inline Vec3d vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

// v with a length of 1; none where it has no direction, or coordinates that aren't any.
inline std::optional<Vec3d> unit(const Vec3d& v) {
  if (!is_coordinate(v) || largest_magnitude(v) == 0) return {};
  return direction(v);
}

struct Transform {
  std::array<Vec3d, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3d offset{0, 0, 0};
};

inline Vec3d transformed_direction(const Transform& m, const Vec3d& v) {
  return {dot(m.rows[0], v), dot(m.rows[1], v), dot(m.rows[2], v)};
}
// The identity changes no bit.
inline Vec3d transformed_point(const Transform& m, const Vec3d& p) {
  return transformed_direction(m, p) + m.offset;
}

inline Transform operator*(const Transform& a, const Transform& b) {
  Transform product;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& row = a.rows[i];
    product.rows[i] = b.rows[0] * row.x + b.rows[1] * row.y + b.rows[2] * row.z;
  }
  product.offset = transformed_point(a, b.offset);
  return product;
}

// Assimp's matrices are affine: the last row is 0 0 0 1.
inline Transform transform_of(const aiMatrix4x4& m) {
  return {{{{m.a1, m.a2, m.a3}, {m.b1, m.b2, m.b3}, {m.c1, m.c2, m.c3}}}, {m.a4, m.b4, m.c4}};
}

// From the node's coordinates to the scene's.
inline Transform global_transform(const aiNode& node) {
  Transform transform = transform_of(node.mTransformation);
  for (const aiNode* parent = node.mParent; parent != nullptr; parent = parent->mParent)
    transform = transform_of(parent->mTransformation) * transform;
  return transform;
}

// Takes normals to the transformed surface's, on the same side of it, also where the transform mirrors or
// flattens: the matrix of cofactors, with the determinant's sign.
struct NormalTransform {
  Transform cofactors;
  bool mirrors;
};
inline NormalTransform normal_transform(const Transform& m) {
  const auto& [x, y, z] = m.rows;
  NormalTransform result{{{{cross(y, z), cross(z, x), cross(x, y)}}, {0, 0, 0}}, false};
  result.mirrors = dot(x, result.cofactors.rows[0]) < 0;
  if (result.mirrors)
    for (Vec3d& row : result.cofactors.rows)
      row = -row;
  return result;
}

} // namespace masu::import
