// Scenes of the C interface: from arrays, or a file.
#include "boundary.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libscene/base/processor.h"
#include "libscene/cuda/host_copies.h"
#include "libscene/geometry/intersect.h"
#include "libscene/mesh/indexed_mesh.h"
#include "libscene/mesh/mesh_check.h"
#include "libscene/mesh/move_passes.h"
#include "libscene/passes/host_executor.h"
#include "objects.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

namespace {

using namespace masu;

void set_color(Vec3f& color, const float* given) {
  if (given == nullptr) return;
  color = {given[0], given[1], given[2]};
  if (!std::isfinite(color.x + color.y + color.z)) fail("color", "isn't finite");
}

IndexedMesh mesh_of(const masu_mesh& given, HostCopies& copies) {
  require_numbers(given.vertices, given.vertices64, given.vertex_count, "vertices");
  IndexedMesh mesh;
  mesh.vertices = given.vertex_count;
  mesh.triangles = given.triangle_count;
  mesh.indices = copies.of(given.indices, 3 * given.triangle_count);
  mesh.floats = copies.of(given.vertices, 3 * given.vertex_count);
  mesh.doubles = copies.of(given.vertices64, 3 * given.vertex_count);
  set_color(mesh.color, given.color);
  return mesh;
}

// Their numbers are those of the primitives, in the same order.
template <class Primitive>
std::vector<PrimitiveArray<Primitive>> arrays_of(const masu_quadrics* given, std::size_t count,
                                                 const char* place, HostCopies& copies) {
  constexpr std::size_t numbers_each = sizeof(Primitive) / sizeof(double);
  std::vector<PrimitiveArray<Primitive>> arrays;
  for_each_taken(given, count, place, [&](const masu_quadrics& one) {
    require_numbers(one.values, one.values64, one.count, place);
    PrimitiveArray<Primitive>& array = arrays.emplace_back();
    array.count = one.count;
    const auto primitives_of = [&](const auto* given_numbers) {
      const auto* const numbers = copies.of(given_numbers, numbers_each * one.count);
      array.primitive = [=](std::size_t i) {
        std::array<double, numbers_each> own;
        std::copy_n(numbers + numbers_each * i, numbers_each, own.begin());
        return std::bit_cast<Primitive>(own);
      };
    };
    one.values != nullptr ? primitives_of(one.values) : primitives_of(one.values64);
    set_color(array.color, one.color);
  });
  return arrays;
}

std::shared_ptr<const SceneFile> shared(SceneFile file) {
  return std::make_shared<const SceneFile>(std::move(file));
}
std::unique_ptr<masu_scene> held(SceneFile file, SceneVertices vertices) {
  return std::make_unique<masu_scene>(masu_scene{shared(std::move(file)), nullptr, std::move(vertices)});
}

// Made of the meshes, and of what stands beside them.
std::unique_ptr<masu_scene> placed(const masu_geometry& given, std::span<const IndexedMesh> meshes,
                                   const ArrayScene& beside, Store store, const std::optional<Vec3d>& origin,
                                   const ProgressMonitor* progress) {
  if (store == Store::automatic) store = Store::float32;
  constexpr Vec3d zero{0, 0, 0};
  auto scene = std::make_shared<PlacedScene>(PlacedScene{
      shared(scene_in_memory(scene_of(meshes, {}, {}, progress), store, zero, progress)), nullptr});
  scene->mesh_triangles.push_back(0);
  for (const IndexedMesh& mesh : meshes)
    scene->mesh_triangles.push_back(scene->mesh_triangles.back() +
                                    static_cast<std::uint32_t>(mesh.triangles));
  for_each_taken(given.placements, given.placement_count, "masu_placement",
                 [&](const masu_placement& placement) {
                   scene->mesh.push_back(placement.mesh);
                   scene->mask.push_back(placement.mask != 0 ? placement.mask : ~0U);
                   scene->world.push_back(placement.world);
                   static_assert(sizeof(Transform) == sizeof placement.transform);
                   std::memcpy(&scene->transforms.emplace_back(), placement.transform, sizeof(Transform));
                 });
  scene->first_triangles = placed_triangles(*scene, beside.spheres.size() + beside.cones.size());
  for (const std::uint32_t world : scene->world)
    if (world != every_world) scene->world_count = std::max(scene->world_count, world + 1);
  const Boxd box = join(scene->box(zero), bounds(beside));
  scene->beside = shared(
      scene_in_memory(beside, store, origin_for(beside, origin ? origin : automatic_origin(box)), progress));
  return std::make_unique<masu_scene>(masu_scene{nullptr, std::move(scene), {}});
}

masu_scene_description described(const masu_scene& scene) {
  const PlacedScene* const placed = scene.placed.get();
  const SceneFile& file = placed != nullptr ? *placed->beside : *scene.file;
  const Vec3d origin = file.origin();
  const Boxd bounds = placed != nullptr ? join(placed->box(origin), file.bounds()) : file.bounds(),
             box = in_world(origin, bounds);
  masu_scene_description about{};
  const auto add = [&](const SceneFile& part) {
    part.with_view_but_triangles([&]<class Stored>(const SceneView<Stored>& view) {
      about.triangles += view.triangle_count;
      about.spheres += view.sphere_count;
      about.cones += view.cone_count;
      about.error_bound = is_empty(bounds) ? 0 : rounding_margin<Stored>(bounds);
    });
    about.materials += static_cast<std::uint32_t>(part.counts().materials);
    about.bytes += part.bytes();
  };
  add(file);
  if (placed != nullptr) add(*placed->meshes);
  about.objects = placed != nullptr ? placed->objects() : file.counts().objects;
  for (int axis = 0; axis < 3; ++axis) {
    about.origin[axis] = origin[axis];
    about.bounds_min[axis] = box.min[axis];
    about.bounds_max[axis] = box.max[axis];
  }
  about.is_float64 = file.is_float64() ? 1 : 0;
  return about;
}

masu_faults faults_of(const MeshFaults& found) {
  masu_faults faults{};
  faults.count = found.count;
  static_assert(std::size(decltype(faults.primitives){}) == decltype(found.first){}.size());
  for (std::size_t i = 0; i < found.examples(); ++i) {
    faults.primitives[i] = found.first[i] / 3;
    faults.corners[i] = found.first[i] % 3;
  }
  return faults;
}

} // namespace

namespace masu {

SceneFile moved_scene(const SceneFile& scene, const Vertices& vertices) {
  const std::uint32_t* const indices = vertices.indices.empty() ? nullptr : vertices.indices.data();
  return scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    const auto moved_by = [&]<class Number>(const Number* numbers) {
      HostCopies copies;
      TbbExecutor executor;
      const WorldVertices<Number> in_host{copies.of(numbers, 3 * vertices.count), indices, scene.origin()};
      const auto moved = moved_triangles(executor, view, in_host, nullptr, 0, max_hierarchy_reach);
      return scene.with_triangles(std::span<const Triangle<Stored>>(moved.triangles), moved.bounds);
    };
    return vertices.floats != nullptr ? moved_by(vertices.floats) : moved_by(vertices.doubles);
  });
}

} // namespace masu

const SceneFile& masu_scene::as_file() const {
  if (file == nullptr) fail("scene", "is of placed meshes, in memory alone: write it out as one of vertices");
  return *file;
}

extern "C" {

masu_status masu_scene_create(const masu_geometry* geometry, masu_scene** scene) {
  return make(scene, "scene", [&] {
    check_processor();
    const masu_geometry given = taken(geometry, "masu_geometry");
    HostCopies copies;
    std::vector<IndexedMesh> meshes;
    for_each_taken(given.meshes, given.mesh_count, "masu_mesh",
                   [&](const masu_mesh& mesh) { meshes.push_back(mesh_of(mesh, copies)); });
    std::optional<Vec3d> origin;
    if (given.origin != nullptr) origin = Vec3d{given.origin[0], given.origin[1], given.origin[2]};
    const auto store = choice<Store>(given.store, 3, "store");
    GoOn go_on(given.go_on, given.user);
    const ProgressMonitor progress(go_on.progress());
    const auto spheres = arrays_of<Sphere<double>>(given.spheres, given.sphere_count, "spheres", copies);
    const auto cones = arrays_of<Cone<double>>(given.cones, given.cone_count, "cones", copies);
    if (given.placement_count > 0)
      return placed(given, meshes, scene_of({}, spheres, cones), store, origin, &progress);
    const ArrayScene arrays = scene_of(meshes, spheres, cones, &progress);
    SceneFile file = scene_in_memory(arrays, store, origin, &progress);
    progress.check();
    return held(std::move(file), {arrays.triangles.vertices().count, arrays.triangles.indices()});
  });
}

masu_status masu_scene_read(const char* path, masu_scene** scene) {
  return make(scene, "scene", [&] {
    check_processor();
    require(path, "path");
    SceneFile file(path);
    const std::uint64_t triangles = file.with_view([](const auto& view) { return view.triangle_count; });
    return held(std::move(file), {3 * triangles, nullptr});
  });
}

masu_status masu_scene_write(const masu_scene* scene, const char* path) {
  return guarded([&] {
    require(scene, "scene");
    require(path, "path");
    scene->as_file().write(path);
  });
}

void masu_scene_free(masu_scene* scene) {
  delete scene;
}

masu_status masu_scene_describe(const masu_scene* scene, masu_scene_description* description) {
  return guarded([&] {
    require(scene, "scene");
    give(described(*scene), description, "masu_scene_description");
  });
}

masu_status masu_scene_primitive(const masu_scene* scene, uint32_t index, masu_primitive* primitive) {
  return guarded([&] {
    require(scene, "scene");
    const SceneFile& file = scene->as_file();
    const std::uint64_t count = file.primitive_count();
    if (index >= count)
      fail("index", fmt::format("{} isn't below {}, the number of primitives", index, count));
    file.with_view([&](const auto& view) {
      const Surface surface = surface_of(view, index);
      const Material& m = view.materials[surface.material];
      give(masu_primitive{sizeof(masu_primitive),
                          index < view.triangle_count                       ? MASU_TRIANGLE
                          : index - view.triangle_count < view.sphere_count ? MASU_SPHERE
                                                                            : MASU_CONE,
                          surface.object,
                          surface.material,
                          face_of(view, index),
                          {m.color.x, m.color.y, m.color.z},
                          m.diffuse,
                          m.specular,
                          m.shine,
                          m.transmittance,
                          m.refraction_index},
           primitive, "masu_primitive");
    });
  });
}

masu_status masu_scene_check(const masu_scene* scene, masu_mesh_check* check) {
  return guarded([&] {
    require(scene, "scene");
    const MeshCheck found = scene->as_file().with_view([](const auto& view) { return check_mesh(view); });
    give(masu_mesh_check{sizeof(masu_mesh_check), found.points, found.edges, faults_of(found.open),
                         faults_of(found.inconsistent), faults_of(found.nonmanifold),
                         faults_of(found.no_area), faults_of(found.duplicates)},
         check, "masu_mesh_check");
  });
}
}
