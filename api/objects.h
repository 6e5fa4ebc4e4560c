// What the C interface's handles are.
#pragma once

#include "libgrid/file/grid_file.h"
#include "libscene/file/scene_file.h"
#include "masu.h"

#include <memory>

// Both are shared with the tracers that use them, so that handles may be freed in any order.
struct masu_scene {
  std::shared_ptr<const masu::SceneFile> file; // in memory
};
struct masu_grid {
  std::shared_ptr<const masu::GridFile> file; // in memory
};

namespace masu {

// What MASU_STRUCTURE_FASTEST builds for a device and on it: the GPU of that number, or MASU_CPU.
GridFile fastest_grid(const SceneFile& scene, int device);
// A hierarchy, built on the CPU with MASU_QUALITY_FAST.
GridFile fast_hierarchy(const SceneFile& scene);

} // namespace masu
