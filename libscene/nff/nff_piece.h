// Parses a piece of NFF text by itself. nff.cpp joins the pieces to a scene.
#pragma once

#include "libscene/material_table.h"
#include "libscene/nff/nff_lexer.h"
#include "libscene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace masu::nff {

// A `v` as written. `place`: for errors found once the scene is complete.
struct View {
  std::string place;
  std::optional<Vec3d> from, look_at, up;
  std::optional<double> angle, hither;
  std::optional<Vec3i> resolution; // z unused
};

struct WrittenLight {
  Vec3d position{};
  std::optional<Vec3d> color;
};

// Indices of objects and normals are relative to the piece. Material `inherited` is the current one at the
// piece's start, n > 0 is materials.materials[n - 1].
struct Piece {
  static constexpr std::uint32_t inherited = 0;

  std::vector<SceneTriangle> triangles;
  std::vector<CornerNormals<double>> normals;
  std::vector<Sphere<double>> spheres;
  std::vector<Surface> sphere_surfaces;
  std::vector<Cone<double>> cones;
  std::vector<Surface> cone_surfaces;
  MaterialTable materials;
  bool uses_inherited = false;
  std::optional<Material> last_material; // current at the piece's end, if the piece sets one

  std::vector<WrittenLight> lights;
  std::optional<View> view; // the last one
  std::optional<Vec3f> background;

  ObjectCounts objects;
  SceneWarnings warnings;
  bool holds_entities = false;
};

// Parses the entities that start before `to`, which is where another one starts, or the text's end. The text
// goes on beyond that entity's first word, so that errors don't depend on where it was cut. Throws
// Error(input).
Piece parse_piece(const Text& text, const char* to);

} // namespace masu::nff
