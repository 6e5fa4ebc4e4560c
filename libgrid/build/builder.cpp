#include "libgrid/build/builder.h"

#include "libgrid/build/hierarchy.h"
#include "libgrid/build/merge.h"
#include "libgrid/build/passes/host_executor.h"
#include "libgrid/build/passes/uniform_passes.h"
#include "libscene/base/error.h"

#include <fmt/format.h>

#include <utility>

namespace masu {

template <class Stored>
Grid GridBuilder<Stored>::build(const GridLayout& layout, Overlap overlap, const GridOptions& options) {
  Grid grid = try_build(layout, overlap, options);
  if (grid.exceeded != nullptr)
    throw Error(ErrorCode::usage, "division", fmt::format("makes {}: choose a coarser one", grid.exceeded));
  return grid;
}
template class GridBuilder<float>;
template class GridBuilder<double>;

template <class Stored>
Grid uniform_grid(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                  ProgressMonitor* progress) {
  TbbExecutor executor{progress};
  return uniform_grid(executor, scene, layout, overlap);
}
template Grid uniform_grid(const SceneView<float>&, const GridLayout&, Overlap, ProgressMonitor*);
template Grid uniform_grid(const SceneView<double>&, const GridLayout&, Overlap, ProgressMonitor*);

namespace {

template <class Stored>
class CpuBuilder final : public GridBuilder<Stored> {
public:
  CpuBuilder(const SceneView<Stored>& scene, std::function<void(double)> progress)
      : GridBuilder<Stored>(std::move(progress)), scene_(scene) {}
  Grid try_build(const GridLayout& layout, Overlap overlap, const GridOptions& options) override {
    ProgressMonitor* const progress = &this->progress();
    if (options.kind == GridKind::hierarchy) return hierarchy_grid(scene_, layout, options.quality, progress);
    return options.kind == GridKind::uniform ? uniform_grid(scene_, layout, overlap, progress)
                                             : merged_grid(scene_, layout, overlap, options, progress);
  }
  bool refit(const GridLayout& layout, Grid& hierarchy) override {
    return refit_hierarchy(scene_, layout, hierarchy);
  }
  const SceneView<Stored>& scene() const override { return scene_; }

private:
  SceneView<Stored> scene_;
};

} // namespace

template <class Stored>
std::unique_ptr<GridBuilder<Stored>> cpu_builder(const SceneView<Stored>& scene,
                                                 std::function<void(double)> progress) {
  return std::make_unique<CpuBuilder<Stored>>(scene, std::move(progress));
}
template std::unique_ptr<GridBuilder<float>> cpu_builder(const SceneView<float>&,
                                                         std::function<void(double)>);
template std::unique_ptr<GridBuilder<double>> cpu_builder(const SceneView<double>&,
                                                          std::function<void(double)>);

} // namespace masu
