// What is taken of an Assimp scene: vectors and transforms, materials, camera and lights.
#pragma once

#include "libscene/mesh/files/mesh_scene.h"

#include <assimp/scene.h>

namespace masu::import {

inline Vec3d vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

// Assimp's matrices are affine: the last row is 0 0 0 1.
inline Transform transform_of(const aiMatrix4x4& m) {
  return {{{{m.a1, m.a2, m.a3}, {m.b1, m.b2, m.b3}, {m.c1, m.c2, m.c3}}}, {m.a4, m.b4, m.c4}};
}

// A material as one of NFF (file_material.h): all numbers are finite and in the range of NFF's.
//
// Phong materials (Collada, FBX, …): Ks is the specular colour's mean times the reflectivity, 0 where none is
// given. Materials of metalness and roughness (glTF): T is the transmission (with the index of refraction, or
// 1.5), else 1 - alpha of the base colour in blended materials (which don't refract).
FileMaterial imported_material(const aiMaterial& material);

bool has_textures(const aiMaterial& material);

// Sets camera, lights, ambient and background of `result.scene`, whose triangles are complete; automatic ones
// where the file has none (complete_view()).
//
// The file's first camera is used if it is a perspective one. Point, spot and area lights become point lights
// (without cone and distance falloff, which NFF's lack), and directional ones point lights 100 radii of the
// scene away.
void import_view(const aiScene& file, const ImportOptions& options, ImportedScene& result);

// Whether Assimp read the file with its importer for this format ("glTF").
bool is_format(const aiScene& file, const char* format);

} // namespace masu::import
