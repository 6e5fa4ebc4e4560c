// Who builds a scene's grids: the CPU, or a CUDA device. Both make the same bytes.
#pragma once

#include "libgrid/build/merge.h"

#include <memory>

namespace masu {

// What building on a device took: making it ready, bringing the primitives there, building, and bringing the
// grids back.
struct DeviceSeconds {
  double set_up = 0, upload = 0, build = 0, download = 0;
};

// The scene must outlive it.
template <class Stored>
class GridBuilder {
public:
  GridBuilder() = default;
  GridBuilder(const GridBuilder&) = delete;
  GridBuilder(GridBuilder&&) = delete;
  GridBuilder& operator=(const GridBuilder&) = delete;
  GridBuilder& operator=(GridBuilder&&) = delete;
  virtual ~GridBuilder() = default;

  // As build_uniform and build_merged do, and throw.
  virtual Grid uniform(const GridLayout& layout, Overlap overlap) = 0;
  virtual Grid merged(const GridLayout& layout, Overlap overlap, const MergeRule& rule) = 0;

  virtual const SceneView<Stored>& scene() const = 0;
  virtual DeviceSeconds device_seconds() const { return {}; }
};

template <class Stored>
std::unique_ptr<GridBuilder<Stored>> cpu_builder(const SceneView<Stored>& scene);

// On the first CUDA device: uniform and irregular grids; for others it throws Error(usage, "--device", …).
// Throws Error(device) where there is none, and when it fails.
template <class Stored>
std::unique_ptr<GridBuilder<Stored>> cuda_builder(const SceneView<Stored>& scene);

} // namespace masu
