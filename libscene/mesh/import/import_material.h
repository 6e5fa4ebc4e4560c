// Materials of an Assimp scene as those of NFF (file_material.h).
//
// Phong materials (Collada, FBX, …): Ks is the specular colour's mean times the reflectivity, 0 where none is
// given. Materials of metalness and roughness (glTF): T is the transmission (with the index of refraction, or
// 1.5), else 1 - alpha of the base colour in blended materials (which don't refract).
#pragma once

#include "libscene/mesh/files/mesh_file.h"

#include <assimp/scene.h>

namespace masu::import {

// All numbers are finite and in the range of NFF's.
FileMaterial imported_material(const aiMaterial& material);

bool has_textures(const aiMaterial& material);

} // namespace masu::import
