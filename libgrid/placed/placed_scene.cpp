#include "libgrid/placed/placed_scene.h"

#include "libgrid/grid/division.h"
#include "libscene/base/error.h"
#include "libscene/base/parallel.h"

#include <fmt/format.h>

#include <algorithm>

namespace masu {
namespace {

template <class Stored>
Box<Stored> box_of(std::span<const Triangle<Stored>> triangles) {
  Box<Stored> box = empty_box<Stored>();
  for (const Triangle<Stored>& triangle : triangles)
    if (has_surface(triangle)) box = join(box, bounds(triangle));
  return box;
}

template <class Stored>
std::span<const Triangle<Stored>> triangles_of(const PlacedScene& scene, const SceneView<Stored>& view,
                                               std::size_t mesh) {
  const std::uint32_t first = scene.mesh_triangles[mesh];
  return {view.triangles + first, scene.mesh_triangles[mesh + 1] - first};
}

// Adds a mesh to those that there are.
template <class Stored>
void add_mesh(std::span<const Triangle<Stored>> triangles, HierarchyQuality quality,
              ProgressMonitor* progress, PlaceableMeshes<Stored>& to) {
  const auto size_of = [](const auto& array) { return static_cast<std::uint32_t>(array.size()); };
  PlacedMesh<Stored> mesh{size_of(to.nodes), size_of(to.leaves), 0, size_of(to.leaf_of), {},
                          box_of(triangles)};
  SceneView<Stored> alone{};
  alone.triangles = triangles.data();
  alone.triangle_count = static_cast<std::uint32_t>(triangles.size());
  Structure hierarchy;
  hierarchy.nodes.resize(1);
  if (!is_empty(mesh.box)) {
    const GridLayout layout = layout_in<Stored>(cast<double>(mesh.box), {1, 1, 1});
    check_hierarchy(triangles.size(), layout.space);
    hierarchy = build_hierarchy(alone, layout, quality, progress);
  }
  for (HierarchyNode node : hierarchy.nodes) {
    node.first_node += mesh.root;
    node.first_reference += mesh.first_leaf;
    to.nodes.push_back(node);
  }
  to.leaf_of.resize(to.leaf_of.size() + triangles.size());
  for (const PrimitiveIndex triangle : hierarchy.references) {
    to.leaf_of[mesh.first_triangle + triangle] = size_of(to.leaves);
    to.leaves.push_back(leaf_of(alone, triangle));
  }
  mesh.leaf_count = size_of(hierarchy.references);
  const auto own = std::span(to.leaves).subspan(mesh.first_leaf);
  for (int axis = 0; axis < 3; ++axis) {
    const auto low = [axis](const Leaf<Stored>& leaf) { return bounds(leaf.record).min[axis]; };
    const auto high = [axis](const Leaf<Stored>& leaf) { return bounds(leaf.record).max[axis]; };
    const auto number = [&](auto leaf) {
      return mesh.first_leaf + static_cast<std::uint32_t>(leaf - own.begin());
    };
    mesh.extremes[2 * axis] = number(std::ranges::min_element(own, {}, low));
    mesh.extremes[2 * axis + 1] = number(std::ranges::max_element(own, {}, high));
  }
  to.meshes.push_back(mesh);
}

template <class Stored>
PlacedOnHost<Stored> made_ready(std::shared_ptr<const PlacedScene> scene,
                                std::shared_ptr<const PlaceableMeshes<Stored>> meshes, bool is_brute_force,
                                const PlacementMoves& moves, const Transform* before) {
  TbbExecutor executor;
  auto arrays = placed(executor,
                       parts_of(*scene, *meshes, scene->beside->view<Stored>(), is_brute_force,
                                [](const auto& array) { return array.data(); }),
                       moves, before);
  return {std::move(scene), std::move(meshes), std::move(arrays)};
}

} // namespace

Boxd PlacedScene::box(const Vec3d& point) const {
  return meshes->with_view([&]<class Stored>(const SceneView<Stored>& view) {
    std::vector<Box<Stored>> boxes(mesh_triangles.size() - 1);
    parallel_for(boxes.size(), [&](std::size_t i) { boxes[i] = box_of(triangles_of(*this, view, i)); });
    Boxd box = empty_box<double>();
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      if (is_empty(boxes[mesh[i]])) continue;
      Placement<Stored> placement{};
      set_transform(point, transforms[i], placement);
      box = join(box, cast<double>(placed_box(placement, boxes[mesh[i]])));
    }
    return box;
  });
}

std::vector<std::uint32_t> placed_triangles(const PlacedScene& scene, std::uint64_t beside) {
  const auto fail = [](std::size_t i, const std::string& what) {
    throw Error(ErrorCode::usage, "placements", fmt::format("number {} {}", i, what));
  };
  std::uint64_t triangles = 0;
  std::vector<std::uint32_t> first{0};
  for (std::size_t i = 0; i < scene.mesh.size(); ++i) {
    const std::uint32_t mesh = scene.mesh[i], world = scene.world[i];
    if (mesh + std::size_t{1} >= scene.mesh_triangles.size())
      fail(i, fmt::format("is of mesh {}: there are {}", mesh, scene.mesh_triangles.size() - 1));
    if (world >= max_worlds && world != every_world)
      fail(i, fmt::format("is in world {}: they are numbered below {}", world, max_worlds));
    const auto is_sound = [&](auto placement) {
      return set_transform({0, 0, 0}, scene.transforms[i], placement);
    };
    if (!(scene.meshes->is_float64() ? is_sound(Placement<double>{}) : is_sound(Placement<float>{})))
      fail(i, not_invertible);
    triangles += scene.mesh_triangles[mesh + 1] - scene.mesh_triangles[mesh];
    if (triangles + beside > max_primitives)
      fail(i, fmt::format("is one too many: all placed triangles are numbered up to {}", max_primitives));
    first.push_back(static_cast<std::uint32_t>(triangles));
  }
  return first;
}

AnyPlacedOnHost placed_on_host(const std::shared_ptr<const PlacedScene>& scene, HierarchyQuality quality,
                               bool is_brute_force, ProgressMonitor* progress) {
  return scene->meshes->with_view([&]<class Stored>(const SceneView<Stored>& view) -> AnyPlacedOnHost {
    PlaceableMeshes<Stored> meshes;
    for (std::size_t i = 0; i + 1 < scene->mesh_triangles.size(); ++i)
      add_mesh(triangles_of(*scene, view, i), quality, progress, meshes);
    return made_ready<Stored>(scene, std::make_shared<const PlaceableMeshes<Stored>>(std::move(meshes)),
                              is_brute_force, moves_of(scene->transforms), nullptr);
  });
}
AnyPlacedOnHost moved(const AnyPlacedOnHost& before, const PlacementMoves& moves) {
  return std::visit(
      [&](const auto& host) -> AnyPlacedOnHost {
        return made_ready(host.scene, host.meshes, host.arrays.parts.is_brute_force, moves,
                          host.arrays.transforms.data());
      },
      before);
}

} // namespace masu
