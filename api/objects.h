// What the C interface's handles are.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/placed/placed_scene.h"
#include "libscene/file/scene_file.h"
#include "libscene/mesh/indexed_mesh.h"
#include "masu.h"
#include "renderer/tracer/tracer.h"

#include <functional>
#include <memory>

namespace masu {

// A scene's vertices as its arrays had them, through all meshes; as a file has them, three per triangle.
struct SceneVertices {
  std::uint64_t count = 0;
  std::shared_ptr<const MeshTriangles::Indices> indices{}; // three per triangle; none: one after the other
};

} // namespace masu

// All are shared with the tracers that use them, so that handles may be freed in any order.
struct masu_scene {
  std::shared_ptr<const masu::SceneFile> file; // in memory; or
  std::shared_ptr<const masu::PlacedScene> placed;
  masu::SceneVertices vertices;

  // Throws Error(usage, "scene", …) for placed meshes, which aren't a file.
  const masu::SceneFile& as_file() const;
};
struct masu_grid {
  std::shared_ptr<const masu::StructureFile> file; // in memory
};

namespace masu {

// A grid for a device, built there: the GPU of that number, or MASU_CPU.
StructureFile usual_grid(const SceneFile& scene, int device, const std::function<void(double)>& progress);

// A scene in memory whose triangles have moved. Throws as moved_triangles() does (move_passes.h).
SceneFile moved_scene(const SceneFile& scene, const Vertices& vertices);

// A hierarchy fitted to a scene whose primitives have moved, or built anew (masu_grid_refit).
StructureFile refitted_grid(const StructureFile& from, const SceneFile& scene);

// Throws Error(usage, "grid", …) for what can't be refitted.
void require_hierarchy(const StructureFile* grid);

} // namespace masu
