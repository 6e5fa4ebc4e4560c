// Reads meshes (OBJ, PLY, STL, glTF, FBX, Collada, …) through Assimp.
//
// Each instance of a mesh, a node of the file that names it, is an object: in the order of a walk over the
// node tree, parents first, a node's meshes before its children. An object's triangles are consecutive, in
// the order of its faces, with the node's transform applied. Faces of more than three corners are
// triangulated as NFF's polygons are (triangulate.h): the same polygons give the same triangles, wherever
// they come from.
//
// Faces are numbered through all objects: Scene::faces. Each has a triangle at least, so that those of a mesh
// of triangles have their faces' numbers: one without area, or with a coordinate that isn't finite or is
// beyond 1e100, has one that nothing can hit (points.h). What has fewer than three corners, a point or a
// line, is no face.
//
// Materials: import_material.h; camera and lights: import_view.h. Points, lines, textures, animations and
// skins aren't imported: meshes have the shape of the bind pose.
#pragma once

#include "libscene/scene.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace masu {

enum class UpAxis { y, z };

struct ImportOptions {
  // Corner normals: the file's, or where a mesh has none, mean normals of the faces round each position.
  bool smooth = false;
  UpAxis up = UpAxis::y; // of the automatic camera only: nothing is rotated
  // Pixels of the picture; 0: the aspect ratio of the file's camera, 512 pixels high.
  std::int32_t width = 0, height = 0;
  std::function<void(double)> progress{}; // gets shares of the reading, as far as Assimp tells
  // Gets the name of each file that Assimp opens: the mesh's own, and those that are referred to.
  std::function<void(const std::string&)> opened{};
  std::function<void()> parsed{}; // is called when Assimp has read all, before the scene is made of it
  std::uint64_t max_primitives = masu::max_primitives;
};

// What a file holds that its scene doesn't, and what was made up.
struct ImportNotes {
  std::uint64_t points_and_lines = 0;          // left out
  std::uint64_t invalid_faces = 0;             // can't be hit: coordinates that aren't finite or beyond 1e100
  std::uint64_t textured_materials = 0;        // have their base colour only
  std::uint64_t omitted_cameras = 0;           // all but the first, and what isn't a perspective
  std::uint64_t omitted_lights = 0;            // ambient ones, and those without a position or direction
  bool has_camera = false, has_lights = false; // false: automatic
};

struct ImportedScene {
  Scene scene;                           // objects count as patches where they have normals, else as polygons
  std::vector<std::string> object_names; // of the node and the mesh
  ImportNotes notes;
};

// Throws Error(input, path, …) for what Assimp can't read, with its own message; for a file without a face;
// for more than 2^31-1 objects or triangles, and where these need more memory than is available.
ImportedScene read_mesh(const std::string& path, const ImportOptions& options = {});

// The same from memory. `extension` (without a dot) tells the format where the bytes don't. Files that the
// mesh refers to are searched for in the current folder.
ImportedScene parse_mesh(std::span<const std::uint8_t> bytes, const std::string& extension,
                         const std::string& name, const ImportOptions& options = {});

} // namespace masu
