#include "libscene/mesh/indexed_mesh.h"

#include "libscene/automatic_camera.h"
#include "libscene/base/error.h"
#include "libscene/mesh/points.h"
#include "libscene/mesh/triangulate.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>

namespace masu {
namespace {

void add(const IndexedMesh& mesh, std::uint32_t object, Scene& scene) {
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorCode::usage, "meshes", fmt::format("mesh {}: {}", object, what));
  };
  constexpr std::size_t none = ~std::size_t{0};
  std::atomic<std::size_t> wrong = none;
  const auto material = static_cast<std::uint32_t>(scene.materials.size());
  const std::size_t first = scene.triangles.size();
  scene.materials.push_back({mesh.color, 1, 0, 0, 0, 1});
  scene.triangles.resize(first + mesh.triangles);
  tbb::parallel_for(std::size_t{0}, mesh.triangles, [&](std::size_t i) {
    const std::uint32_t* const corners = mesh.indices + 3 * i;
    if (corners[0] >= mesh.vertices || corners[1] >= mesh.vertices || corners[2] >= mesh.vertices) {
      wrong = i;
      return;
    }
    const Vec3d a = mesh.vertex(corners[0]), b = mesh.vertex(corners[1]), c = mesh.vertex(corners[2]);
    if (!is_coordinate(a) || !is_coordinate(b) || !is_coordinate(c)) wrong = i;
    const bool is_surface = has_area(a, b, c);
    scene.triangles[first + i] = {a, object, is_surface ? b : a, material, is_surface ? c : a, no_normals};
  });
  if (wrong != none)
    fail(
        fmt::format("triangle {} has a vertex that there isn't, or whose coordinates aren't finite or beyond "
                    "1e100",
                    wrong.load()));
}

} // namespace

Scene scene_of(std::span<const IndexedMesh> meshes) {
  Scene scene{};
  std::size_t triangles = 0;
  for (const IndexedMesh& mesh : meshes)
    triangles += mesh.triangles;
  if (triangles > max_primitives || meshes.size() > max_primitives)
    throw Error(ErrorCode::usage, "meshes", "have more triangles than a scene may hold");
  scene.triangles.reserve(triangles);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    add(meshes[i], static_cast<std::uint32_t>(i), scene);
  place_points(scene.triangles);
  scene.objects.polygons = meshes.size();
  scene.camera = automatic_camera(bounding_sphere(scene), false, 512, 512);
  scene.ambient = 0.5F; // of one light
  scene.lights = {{scene.camera.from, {0.5, 0.5, 0.5}}};
  return scene;
}

} // namespace masu
