// Structure builders: the CPU, or a CUDA device. Both make the same bytes.
#pragma once

#include "libgrid/structure/structure.h"
#include "libscene/base/progress_monitor.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace masu {

class MeshTriangles; // libscene/mesh/indexed_mesh.h

// What building on a device took: initialising it, uploading the primitives, building, and downloading the
// grids.
struct DeviceSeconds {
  double set_up = 0, upload = 0, build = 0, download = 0;
};

// The scene must outlive it.
template <class Stored>
class StructureBuilder {
public:
  // What `progress` throws ends a build, and any thread may call it (progress_monitor.h).
  explicit StructureBuilder(const SceneView<Stored>& scene, std::function<void(double)> progress = {})
      : scene_(scene), progress_(std::move(progress)) {}
  StructureBuilder(const StructureBuilder&) = delete;
  StructureBuilder& operator=(const StructureBuilder&) = delete;
  virtual ~StructureBuilder() = default;

  // A grid of any kind but automatic. For a hierarchy the layout's space and margin matter alone. Throws
  // Error(input) for more primitives than grids can number, and Error(usage, "structure", …) for a hierarchy
  // of a scene that reaches too far.
  virtual Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) = 0;
  // The same, but throws Error(usage, "division", …) for a layout that exceeds a limit.
  Structure build(const GridLayout& layout, Overlap overlap, const StructureOptions& options = {}) {
    Structure grid = try_build(layout, overlap, options);
    if (grid.exceeded != nullptr)
      throw Error(ErrorCode::usage, "division",
                  std::string("makes ") + grid.exceeded + ": choose a coarser one, or a hierarchy");
    return grid;
  }

  const SceneView<Stored>& scene() const { return scene_; }
  virtual DeviceSeconds device_seconds() const { return {}; }
  // Of what is built next.
  ProgressMonitor& progress() { return progress_; }

private:
  SceneView<Stored> scene_;
  ProgressMonitor progress_;
};

// `progress` gets shares of the work of merged grids and hierarchies of high quality.
template <class Stored>
std::unique_ptr<StructureBuilder<Stored>> cpu_builder(const SceneView<Stored>& scene,
                                                      std::function<void(double)> progress = {});

// Triangles that a device makes of their meshes, and a scene's view doesn't have: for hierarchies alone.
struct UnmadeTriangles {
  const MeshTriangles* meshes;
  Vec3d origin; // the scene's
};

// On a CUDA device, which is the thread's current one until the builder is destroyed. `is_timed`: all code is
// brought to the device first, so that device_seconds() are of building alone. Throws Error(device) where
// there is none, and when it fails.
template <class Stored>
std::unique_ptr<StructureBuilder<Stored>>
cuda_builder(const SceneView<Stored>& scene, int device = 0, std::function<void(double)> progress = {},
             bool is_timed = true, const UnmadeTriangles* unmade = nullptr);

// On the CPU.
template <class Stored>
Structure build_structure(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                          const StructureOptions& options = {}) {
  return cpu_builder(scene)->build(layout, overlap, options);
}

} // namespace masu
