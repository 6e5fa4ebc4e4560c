// Affine transforms of a mesh's points and normals, in double.
#pragma once

#include "libscene/automatic_camera.h"

#include <array>
#include <cmath>
#include <optional>

namespace masu {

// v with a length of 1; none where it has no direction, or none that a double's range leaves.
inline std::optional<Vec3d> unit(const Vec3d& v) {
  if (!is_finite(v) || largest_magnitude(v) < 1e-300) return {};
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

} // namespace masu
