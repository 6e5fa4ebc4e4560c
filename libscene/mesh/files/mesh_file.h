// What a mesh's file says, with all its digits: polygons whose corners are numbers of shared positions. Those
// of the four formats that people exchange are read here, any other by Assimp (import/); mesh_scene.h makes a
// scene of either.
//
// The readers refuse what is cut or contradicts itself: counts that aren't there, numbers of vertices out of
// range, what isn't a number. Errors name the line, and of what was read at most a word's beginning.
#pragma once

#include "libscene/automatic_camera.h"
#include "libscene/base/growing_array.h"
#include "libscene/scene.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

// v with a length of 1; none where it has no direction, or none that a double's range leaves.
inline std::optional<Vec3d> unit(const Vec3d& v) {
  if (!is_finite(v) || largest_magnitude(v) < 1e-300) return {};
  return direction(v);
}

// An affine transform of points, in double.
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

// What a file holds that its scene doesn't, and what was made up.
struct ImportNotes {
  std::uint64_t points_and_lines = 0;   // left out
  std::uint64_t invalid_faces = 0;      // can't be hit: coordinates that aren't finite or beyond 1e100
  std::uint64_t textured_materials = 0; // have their base colour only
  std::uint64_t omitted_cameras = 0;    // all but the first, and what isn't a perspective
  std::uint64_t omitted_lights = 0;     // ambient ones, and those without a position or direction
  std::uint64_t unknown_lines = 0;      // of an OBJ, left out: curves and surfaces, words that aren't of it
  std::uint64_t missing_libraries = 0;  // files of materials that an OBJ names
  double float32_error = 0; // of Assimp's coordinates, where it is more than 1e-5 of the scene's extent
  std::uint64_t trailing_bytes = 0;            // after the last face that a binary file promises
  bool has_camera = false, has_lights = false; // false: automatic
};

struct FileMaterial {
  Material material{};
  bool multiplies_vertex_colors = false; // as glTF's; else vertex colours replace the material's
};

// Faces of one material under one name.
struct MeshObject {
  std::string name{};
  std::uint32_t material = 0;
  bool has_normals = false, has_colors = false;
  std::uint64_t first_face = 0, faces = 0, first_corner = 0, corners = 0;
  Transform transform{}; // from the positions' coordinates to the scene's

  std::uint64_t triangles() const { return corners - 2 * faces; }
};

inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

struct MeshFile {
  GrowingArray<Vec3d> positions;
  GrowingArray<Vec3f> colors;                 // of the positions, NaN where one has none; or none at all
  GrowingArray<Vec3d> normals;                // of the positions, where corner_normals is empty
  GrowingArray<std::uint32_t> corners;        // of all faces, in turn: positions
  GrowingArray<std::uint32_t> corner_normals; // of all corners: normals, or no_index
  GrowingArray<std::uint32_t> face_sizes;     // corners of each face: three at least
  std::vector<FileMaterial> materials;
  std::vector<MeshObject> objects;
  ImportNotes notes;
};

// From now on faces are of that object.
void begin_object(MeshFile& file, const std::string& name, std::uint32_t material);
// One of fewer than three corners is none, and counted as a point or line.
void add_face(MeshFile& file, std::span<const std::uint32_t> corners);

enum class MeshFormat { obj, ply, off, stl };

// The ending of a file's name, without its dot; the format of that ending, or of what a file of another name
// begins with.
std::string extension_of(const std::filesystem::path& path);
std::optional<MeshFormat> format_of_name(const std::string& extension);
std::optional<MeshFormat> format_of_content(std::string_view file);

// A file, and how it is read.
struct MeshText {
  std::string_view bytes;
  const std::string& name; // in errors
  // The text of a file that this one names; none where there isn't any.
  std::function<std::optional<std::string>(const std::string&)> other_file{};
  std::function<void(double)> progress{}; // gets the share that was read
};

// Throws Error(input, its name or its name:line, …).
MeshFile parse_mesh_file(const MeshText& text, MeshFormat format);
MeshFile parse_obj(const MeshText& text);
MeshFile parse_ply(const MeshText& text);
MeshFile parse_off(const MeshText& text);
MeshFile parse_stl(const MeshText& text);

} // namespace masu
