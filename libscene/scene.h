// A scene in host memory: made by the NFF parser, written to a scene file.
#pragma once

#include "libscene/base/growing_array.h"
#include "libscene/geometry/primitives.h"

#include <cstdint>
#include <vector>

namespace masu {

// Right-handed. `angle`: vertical field of view in degrees. `hither`: distance of the near plane, as given in
// the file.
struct Camera {
  Vec3d from, at, up;
  double angle;
  double hither;
  std::int32_t width, height; // pixels
};

// The fill of an `f` line: colour, diffuse, specular, shine (the highlight's exponent), transmittance, index
// of refraction. Also the record of the scene file.
struct Material {
  Vec3f color;
  float diffuse, specular, shine, transmittance, refraction_index;

  friend bool operator==(const Material&, const Material&) = default;
};
static_assert(sizeof(Material) == 32);

MASU_HD inline bool reflects(const Material& m) {
  return m.specular > 0;
}
MASU_HD inline bool transmits(const Material& m) {
  return m.transmittance > 0;
}

// A point light: intensity is the light's own colour, or the scene's default (√n/(2n) for n lights).
template <class Stored>
struct Light {
  Vec3<Stored> position;
  Vec3<Stored> intensity;
};
template <class To, class From>
Light<To> cast(const Light<From>& l) {
  return {cast<To>(l.position), cast<To>(l.intensity)};
}
static_assert(sizeof(Light<float>) == 24 && sizeof(Light<double>) == 48);

// Counts of input that can't be rendered as given, for a tool to warn about.
struct SceneWarnings {
  std::uint64_t degenerate_polygons = 0;    // no area: dropped, or of a mesh, can't be hit
  std::uint64_t degenerate_triangles = 0;   // slivers without area inside a polygon: dropped
  std::uint64_t degenerate_spheres = 0;     // radius 0: dropped
  std::uint64_t degenerate_cones = 0;       // no length, or both radii 0: dropped
  std::uint64_t self_crossing_polygons = 0; // have no proper triangulation: approximated
};

// Number of objects in the NFF text by entity, degenerate ones included.
struct ObjectCounts {
  std::uint64_t polygons = 0, patches = 0, spheres = 0, cones = 0;

  std::uint64_t sum() const { return polygons + patches + spheres + cones; }
};
inline constexpr std::uint64_t max_objects = 0x7fffffff; // indices are int32, with -1 for none

// The largest magnitude of a coordinate as it is given. NaN isn't one.
inline constexpr double max_coordinate = 1e100;
MASU_HD inline bool is_coordinate(const Vec3d& v) {
  return std::abs(v.x) <= max_coordinate && std::abs(v.y) <= max_coordinate &&
         std::abs(v.z) <= max_coordinate;
}

// A Triangle<double> without the padding that its loads need.
struct SceneTriangle {
  Vec3d a, b, c;
  std::uint32_t object, material, normals;

  SceneTriangle() = default;
  SceneTriangle(const Vec3d& a_, std::uint64_t object_, const Vec3d& b_, std::uint64_t material_,
                const Vec3d& c_, std::uint64_t normals_)
      : a(a_), b(b_), c(c_), object(static_cast<std::uint32_t>(object_)),
        material(static_cast<std::uint32_t>(material_)), normals(static_cast<std::uint32_t>(normals_)) {}
  SceneTriangle(const Triangle<double>& t) : SceneTriangle(t.a, t.object, t.b, t.material, t.c, t.normals) {}
  operator Triangle<double>() const { return {a, object, b, material, c, normals}; }
};
static_assert(sizeof(SceneTriangle) == 88);

inline Boxd bounds(const SceneTriangle& t) {
  return join(join(Boxd{t.a, t.a}, t.b), t.c);
}
inline Triangle<double> widened(const SceneTriangle& t) {
  return t;
}

// Geometry is double until the file is written: only then is it known whether float32 is precise enough.
// Triangles: SceneTriangle records by number, and how many they are.
template <class Triangles>
struct SceneOf {
  Camera camera{};
  Vec3f background{};
  float ambient = 0;       // √n/(2n) for n lights
  bool has_camera = false; // the file had a `v`, else the camera is the default one
  std::vector<Light<double>> lights;
  std::vector<Material> materials;

  Triangles triangles;
  GrowingArray<CornerNormals<double>> normals;
  GrowingArray<Sphere<double>> spheres;
  GrowingArray<Surface> sphere_surfaces;
  GrowingArray<Cone<double>> cones;
  GrowingArray<Surface> cone_surfaces;
  // Of each triangle, the number of the mesh's face that it is of; empty: each is its own.
  GrowingArray<std::uint32_t> faces;

  ObjectCounts objects;
  SceneWarnings warnings;
};
using Scene = SceneOf<GrowingArray<SceneTriangle>>;

} // namespace masu
