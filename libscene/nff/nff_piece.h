// A piece of NFF text, parsed by itself: what nff.cpp joins to a scene.
#pragma once

#include "libscene/nff/nff_lexer.h"
#include "libscene/scene.h"

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace masu::nff {

struct MaterialHash {
  std::size_t operator()(const Material& m) const;
};
struct MaterialEqual {
  bool operator()(const Material& a, const Material& b) const;
};

// Materials in the order of their first use, each once.
struct MaterialTable {
  std::vector<Material> materials;
  std::unordered_map<Material, std::uint32_t, MaterialHash, MaterialEqual> places;

  std::uint32_t place_of(const Material& material);
};

// A `v` as written; where it stands is for errors that show only once the scene is whole.
struct View {
  const char* at = nullptr;
  std::optional<Vec3d> from, look_at, up;
  std::optional<double> angle, hither;
  std::optional<Vec3i> resolution; // z unused
};

struct WrittenLight {
  Vec3d position{};
  std::optional<Vec3d> color;
};

// Objects and normals are numbered from the piece's own start. Material `inherited` is the one in force
// before the piece, n > 0 is materials.materials[n - 1].
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
  std::optional<Material> last_material; // in force at the piece's end, if the piece says

  std::vector<WrittenLight> lights;
  std::optional<View> view; // the last one
  std::optional<Vec3f> background;

  ObjectCounts objects;
  SceneWarnings warnings;
  bool holds_entities = false;
  bool float32_suffices = true;
};

// Parses the entities that start in [from, to). Reads on to the text's end where an entity goes on, so that
// errors don't depend on where the text was cut. Throws Error(input).
Piece parse_piece(const Text& text, const char* from, const char* to);

} // namespace masu::nff
