// Camera and lights of an Assimp scene, or automatic ones (complete_view()).
//
// The file's first camera is used if it is a perspective one. Point, spot and area lights become point lights
// (without cone and distance falloff, which NFF's lack), and directional ones point lights 100 radii of the
// scene away.
#pragma once

#include "libscene/mesh/files/mesh_scene.h"

#include <assimp/scene.h>

namespace masu::import {

// Sets camera, lights, ambient and background of `result.scene`, whose triangles are complete.
void import_view(const aiScene& file, const ImportOptions& options, ImportedScene& result);

// Whether Assimp read the file with its importer for this format ("glTF").
bool is_format(const aiScene& file, const char* format);

} // namespace masu::import
