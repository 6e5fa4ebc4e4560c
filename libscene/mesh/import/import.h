// Reads meshes of any format: OBJ, PLY, OFF and STL by readers of our own, with all their digits
// (files/mesh_file.h), others (glTF, FBX, Collada, …) through Assimp, which has coordinates as float32.
//
// Of a file that Assimp reads each instance of a mesh, a node that names it, is an object: in the order of a
// walk over the node tree, parents first, a node's meshes before its children.
//
// Materials, camera and lights: assimp_scene.h. Points, lines, textures, animations and
// skins aren't imported: meshes have the shape of the bind pose.
#pragma once

#include "libscene/mesh/files/mesh_scene.h"

#include <string>

namespace masu {

// The format is that of the path's ending where it is known, else that of what the file begins with. Throws
// Error(input, path or path:line, …) for what can't be read, of Assimp with its own message; and as
// scene_of().
ImportedScene read_mesh(const std::string& path, const ImportOptions& options = {});

} // namespace masu
