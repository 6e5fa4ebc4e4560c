#include "libscene/mesh/indexed_mesh.h"

#include "libscene/automatic_camera.h"
#include "libscene/base/error.h"
#include "libscene/mesh/points.h"
#include "libscene/mesh/triangle_area.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace masu {
namespace {

constexpr std::size_t none = ~std::size_t{0};

void add(const IndexedMesh& mesh, std::uint32_t object, Scene& scene, const ProgressMonitor* progress) {
  std::atomic<std::size_t> wrong = none;
  const auto material = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({mesh.color, 1, 0, 0, 0, 1});
  const std::span<SceneTriangle> triangles = scene.triangles.extend(mesh.triangles);
  tbb::parallel_for(std::size_t{0}, mesh.triangles, [&](std::size_t i) {
    if (i % 4096 == 0) check_progress(progress);
    std::array<std::size_t, 3> corners{3 * i, 3 * i + 1, 3 * i + 2};
    if (mesh.indices != nullptr) std::copy_n(mesh.indices + 3 * i, 3, corners.begin());
    if (corners[0] >= mesh.vertices || corners[1] >= mesh.vertices || corners[2] >= mesh.vertices) {
      wrong = i;
      return;
    }
    const Vec3d a = mesh.vertex(corners[0]), b = mesh.vertex(corners[1]), c = mesh.vertex(corners[2]);
    if (!is_coordinate(a) || !is_coordinate(b) || !is_coordinate(c)) wrong = i;
    const bool is_surface = has_distinct_corners(a, b, c);
    triangles[i] = {a, object, is_surface ? b : a, material, is_surface ? c : a, no_normals};
  });
  if (wrong != none)
    throw Error(ErrorCode::usage, "meshes",
                fmt::format("mesh {}: triangle {} has a vertex that there isn't, or whose coordinates aren't "
                            "finite or beyond 1e100",
                            object, wrong.load()));
}

bool is_valid(const Sphere<double>& s) {
  return is_coordinate(s.center) && is_coordinate({s.radius, 0, 0}) && s.radius != 0;
}
bool is_valid(const Cone<double>& c) {
  return is_coordinate(c.base) && is_coordinate(c.apex) && is_coordinate({c.base_radius, c.apex_radius, 0}) &&
         !(c.base == c.apex) && (c.base_radius != 0 || c.apex_radius != 0) &&
         (c.base_radius == 0 || c.apex_radius == 0 || (c.base_radius < 0) == (c.apex_radius < 0));
}

template <class Primitive>
void add(const PrimitiveArray<Primitive>& array, std::size_t object, const char* place, Scene& scene,
         GrowingArray<Primitive>& primitives, GrowingArray<Surface>& surfaces) {
  const Surface surface{static_cast<std::uint32_t>(object),
                        static_cast<std::uint32_t>(scene.materials.size())};
  scene.materials.push_back({array.color, 1, 0, 0, 0, 1});
  for (std::size_t i = 0; i < array.count; ++i) {
    primitives.push_back(array.primitive(i));
    surfaces.push_back(surface);
    if (!is_valid(primitives.back()))
      throw Error(ErrorCode::usage, place,
                  fmt::format("object {}: number {} has no surface, radii of both signs, or a number that "
                              "isn't finite or beyond 1e100",
                              object, i));
  }
}

template <class Objects, class Count>
std::size_t sum(const Objects& objects, const Count& count) {
  std::size_t all = 0;
  for (const auto& object : objects)
    all = std::min(all, max_primitives + 1) + std::min(count(object), max_primitives + 1);
  return all;
}

} // namespace

Scene scene_of(std::span<const IndexedMesh> meshes, std::span<const SphereArray> spheres,
               std::span<const ConeArray> cones, const ProgressMonitor* progress) {
  Scene scene{};
  const auto count = [](const auto& array) -> std::uint64_t { return array.count; };
  const std::uint64_t triangles =
      sum(meshes, [](const IndexedMesh& mesh) -> std::uint64_t { return mesh.triangles; });
  if (triangles + sum(spheres, count) + sum(cones, count) > max_primitives ||
      meshes.size() + spheres.size() + cones.size() > max_primitives)
    throw Error(ErrorCode::usage, "geometry", "has more primitives than a scene may hold");
  scene.triangles.reserve(triangles);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    add(meshes[i], static_cast<std::uint32_t>(i), scene, progress);
  place_points(scene.triangles);
  std::size_t object = meshes.size();
  for (const SphereArray& array : spheres)
    add(array, object++, "spheres", scene, scene.spheres, scene.sphere_surfaces);
  for (const ConeArray& array : cones)
    add(array, object++, "cones", scene, scene.cones, scene.cone_surfaces);
  scene.objects = {meshes.size(), 0, spheres.size(), cones.size()};
  scene.camera = automatic_camera(bounding_sphere(scene), false, 512, 512);
  scene.ambient = 0.5F; // of one light
  scene.lights = {{scene.camera.from, {0.5, 0.5, 0.5}}};
  return scene;
}

} // namespace masu
