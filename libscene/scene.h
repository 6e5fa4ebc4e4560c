// A scene in host memory: made by the NFF parser, written to a scene file.
#pragma once

#include "libscene/geometry/primitives.h"

#include <cstdint>
#include <string>
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
static_assert(sizeof(Light<float>) == 24 && sizeof(Light<double>) == 48);

// Counts of input that can't be rendered as given, for a tool to warn about.
struct SceneWarnings {
  std::uint64_t degenerate_polygons = 0;    // no area: dropped
  std::uint64_t degenerate_triangles = 0;   // slivers without area inside a polygon: dropped
  std::uint64_t degenerate_spheres = 0;     // radius 0: dropped
  std::uint64_t degenerate_cones = 0;       // no length, or both radii 0: dropped
  std::uint64_t self_crossing_polygons = 0; // have no proper triangulation: approximated
};

// Number of objects in the NFF text by entity, degenerate ones included.
struct ObjectCounts {
  std::uint64_t polygons = 0, patches = 0, spheres = 0, cones = 0;
};

// Geometry is double until the file is written: only then is it known whether float32 is precise enough.
struct Scene {
  Camera camera;
  Vec3f background;
  float ambient;   // √n/(2n) for n lights
  bool has_camera; // false: the file had no `v`, and the camera is the default one
  std::vector<Light<double>> lights;
  std::vector<Material> materials;

  std::vector<Triangle<double>> triangles;
  std::vector<CornerNormals<double>> normals;
  std::vector<Sphere<double>> spheres;
  std::vector<Surface> sphere_surfaces;
  std::vector<Cone<double>> cones;
  std::vector<Surface> cone_surfaces;

  ObjectCounts objects;
  SceneWarnings warnings;
};

} // namespace masu
