// Scenes of placed meshes in host memory: each mesh once, and where it is placed how often.
#pragma once

#include "libgrid/placed/place_passes.h"
#include "libgrid/structure/structure.h"
#include "libscene/passes/host_executor.h"

#include <memory>
#include <variant>
#include <vector>

namespace masu {

// All that doesn't move, and where what does begins. In memory alone: there is no file of it.
struct PlacedScene {
  std::shared_ptr<const SceneFile> meshes; // in their own spaces: an object each
  std::shared_ptr<const SceneFile> beside; // spheres and cones, relative to the scene's origin
  // Of each mesh the first of its triangles among those of all; and where they end.
  std::vector<std::uint32_t> mesh_triangles{};
  std::vector<std::uint32_t> mesh{}, mask{}, world{}, first_triangles{}; // of placements, as PlacedParts
  std::vector<Transform> transforms{};
  std::uint32_t world_count = 0; // one more than the highest

  Vec3d origin() const { return beside->origin(); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(mesh.size()); }
  // Placements first, then the objects of what stands beside them.
  std::uint64_t objects() const { return count() + beside->counts().objects; }
  // Around the boxes of meshes as they are placed at the beginning, relative to a point.
  Boxd box(const Vec3d& point) const;
};

inline constexpr std::uint32_t max_worlds = 1 << 20;

// `first_triangles` of placements of these meshes beside so many other primitives. Throws
// Error(usage, "placements", …) for a mesh or a world that there isn't, a transform that can't be inverted,
// and more triangles than a scene may have.
std::vector<std::uint32_t> placed_triangles(const PlacedScene& scene, std::uint64_t beside);

// Meshes and their hierarchies, ready to be placed.
template <class Stored>
struct PlaceableMeshes {
  HostArray<HierarchyNode> nodes{};
  HostArray<Leaf<Stored>> leaves{};
  HostArray<std::uint32_t> leaf_of{};
  std::vector<PlacedMesh<Stored>> meshes{};
};

// Of a scene with its `beside` as it is seen, where array(one of the host's) says that an array lies.
template <class Stored, class ArrayAt>
PlacedParts<Stored> parts_of(const PlacedScene& scene, const PlaceableMeshes<Stored>& meshes,
                             const SceneView<Stored>& beside, bool is_brute_force, const ArrayAt& array) {
  return {{array(meshes.nodes), array(meshes.leaves), array(meshes.leaf_of)},
          array(meshes.meshes),
          array(scene.mesh),
          array(scene.mask),
          array(scene.world),
          array(scene.first_triangles),
          scene.count(),
          scene.world_count,
          scene.first_triangles.back(),
          scene.origin(),
          beside,
          scene.beside->bounds(),
          is_brute_force};
}

// A placed scene, ready to be traced on the CPU.
template <class Stored>
struct PlacedOnHost {
  std::shared_ptr<const PlacedScene> scene;
  std::shared_ptr<const PlaceableMeshes<Stored>> meshes;
  PlacedArrays<TbbExecutor, Stored> arrays;
};
using AnyPlacedOnHost = std::variant<PlacedOnHost<float>, PlacedOnHost<double>>;

// At first, when meshes' hierarchies are built, on the CPU; and moved, from host memory. Throw as
// build_hierarchy() and placed() do.
AnyPlacedOnHost placed_on_host(const std::shared_ptr<const PlacedScene>& scene, HierarchyQuality quality,
                               bool is_brute_force, ProgressMonitor* progress);
AnyPlacedOnHost moved(const AnyPlacedOnHost& before, const PlacementMoves& moves);

} // namespace masu
