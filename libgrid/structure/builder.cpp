#include "libgrid/structure/builder.h"

#include "libgrid/grid/merge.h"
#include "libgrid/grid/uniform_passes.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libscene/base/error.h"
#include "libscene/passes/host_executor.h"

#include <fmt/format.h>

#include <utility>

namespace masu {

template <class Stored>
Grid GridBuilder<Stored>::build(const GridLayout& layout, Overlap overlap, const GridOptions& options) {
  Grid grid = try_build(layout, overlap, options);
  if (grid.exceeded != nullptr)
    throw Error(ErrorCode::usage, "division",
                fmt::format("makes {}: choose a coarser one, or a hierarchy", grid.exceeded));
  return grid;
}
template class GridBuilder<float>;
template class GridBuilder<double>;

namespace {

template <class Stored>
class CpuBuilder final : public GridBuilder<Stored> {
public:
  CpuBuilder(const SceneView<Stored>& scene, std::function<void(double)> progress)
      : GridBuilder<Stored>(std::move(progress)), scene_(scene) {}
  Grid try_build(const GridLayout& layout, Overlap overlap, const GridOptions& options) override {
    ProgressMonitor* const progress = &this->progress();
    if (options.kind == GridKind::hierarchy) return hierarchy_grid(scene_, layout, options.quality, progress);
    if (options.kind != GridKind::uniform) return merged_grid(scene_, layout, overlap, options, progress);
    TbbExecutor executor{progress};
    return uniform_grid(executor, scene_, layout, overlap, options.max_references, options.max_map_words);
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
