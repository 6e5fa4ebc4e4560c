// The scene of a mesh's file.
//
// An object's triangles are consecutive, in the order of its faces, with its transform applied. Faces of more
// than three corners are triangulated as NFF's polygons are (triangulate.h): the same polygons give the same
// triangles, wherever they come from.
//
// Faces are numbered through all objects: Scene::faces. Each has a triangle at least, so that those of a mesh
// of triangles have their faces' numbers: a triangle of which two corners coincide, a larger face without
// area, and one with a coordinate that isn't finite or is beyond 1e100 have one that nothing can hit
// (triangle_area.h). What has fewer than three corners, a point or a line, is no face.
#pragma once

#include "libscene/mesh/files/mesh_file.h"

#include <filesystem>

namespace masu {

enum class UpAxis { y, z };

struct ImportOptions {
  // Corner normals: the file's, or where a mesh has none, mean normals of the faces round each position.
  bool smooth = false;
  UpAxis up = UpAxis::y; // of the automatic camera only: nothing is rotated
  // Pixels of the picture; 0: the aspect ratio of the file's camera, 512 pixels high.
  std::int32_t width = 0, height = 0;
  std::function<void(double)> progress{}; // gets shares of the reading
  // Gets the name of each file that is opened: the mesh's own, and those that are referred to.
  std::function<void(const std::string&)> opened{};
  std::function<void()> parsed{}; // is called when all is read, before the scene is made of it
  std::uint64_t max_primitives = masu::max_primitives;
};

struct ImportedScene {
  Scene scene;                           // objects count as patches where they have normals, else as polygons
  std::vector<std::string> object_names; // of the node and the mesh
  ImportNotes notes;
};

// Triangles and materials. Throws Error(input, name, …) for a file without a face; for more than 2^31-1
// objects or options.max_primitives triangles, and where these need more memory than is available.
ImportedScene scene_of(const MeshFile& file, const std::string& name, const ImportOptions& options);

// Completes what the file says of camera and lights. Without a camera the automatic one looks at the whole
// scene from the front, right and above, as NFF's does, with the scene's up axis as its up, and 45°. Colours
// of lights are scaled together so that the brightest component of all is NFF's default √n/(2n) for n lights:
// units of files differ. Without any, there is a light at the file's camera, or above and to the left of the
// automatic one.
void complete_view(const Sphere<double>& whole, const ImportOptions& options, ImportedScene& result);

// Reads a mesh, and from its folder the files of materials that it names: regular ones alone, for pipes and
// devices could be read for ever. Throws as parse_mesh_file() does.
MeshFile read_mesh_file(std::span<const std::uint8_t> bytes, MeshFormat format,
                        const std::filesystem::path& folder, const std::string& name,
                        const ImportOptions& options);

// Both: the scene of a file that says nothing of a view.
ImportedScene viewed_scene_of(const MeshFile& file, const std::string& name, const ImportOptions& options);

} // namespace masu
