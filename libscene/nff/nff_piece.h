// Parses a piece of NFF text by itself. nff.cpp joins the pieces to a scene.
#pragma once

#include "libscene/material_table.h"
#include "libscene/nff/nff_lexer.h"
#include "libscene/scene.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace masu::nff {

// A `v` as written. `position`: in the text, for errors found once the scene is complete.
struct View {
  const char* position = nullptr;
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

  std::vector<Triangle<double>> triangles;
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

// Parses the entities that start in [from, to). The last one may continue beyond `to`, so that errors don't
// depend on where the text was cut. Throws Error(input).
Piece parse_piece(const Text& text, const char* from, const char* to);

} // namespace masu::nff
