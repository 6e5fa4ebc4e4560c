// Vectors and transforms of an Assimp scene.
#pragma once

#include "libscene/mesh/files/transform.h"

#include <assimp/scene.h>

namespace masu::import {

inline Vec3d vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
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

} // namespace masu::import
