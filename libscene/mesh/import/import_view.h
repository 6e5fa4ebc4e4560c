// Camera and lights of an Assimp scene, or automatic ones.
//
// The file's first camera is used if it is a perspective one. Otherwise the camera looks at the whole scene
// from the front, right and above, as NFF's automatic one does, with the scene's up axis as its up, and 45°.
//
// Point, spot and area lights become point lights (without cone and distance falloff, which NFF's lack), and
// directional ones point lights 100 radii of the scene away. Their colours are scaled together so that the
// brightest component of all is NFF's default √n/(2n) for n lights: units of files differ. Without any, there
// is a light at the file's camera, or above and to the left of the automatic one.
#pragma once

#include "libscene/mesh/import/import.h"

#include <assimp/scene.h>

namespace masu::import {

// Sets camera, lights, ambient and background of `result.scene`, whose triangles are complete.
void import_view(const aiScene& file, const ImportOptions& options, ImportedScene& result);

// Whether Assimp read the file with its importer for this format ("glTF", "(STL)").
bool is_format(const aiScene& file, const char* format);

} // namespace masu::import
