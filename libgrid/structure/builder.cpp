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
Structure StructureBuilder<Stored>::build(const GridLayout& layout, Overlap overlap,
                                          const StructureOptions& options) {
  Structure grid = try_build(layout, overlap, options);
  if (grid.exceeded != nullptr)
    throw Error(ErrorCode::usage, "division",
                fmt::format("makes {}: choose a coarser one, or a hierarchy", grid.exceeded));
  return grid;
}
template class StructureBuilder<float>;
template class StructureBuilder<double>;

namespace {

template <class Stored>
class CpuBuilder final : public StructureBuilder<Stored> {
public:
  CpuBuilder(const SceneView<Stored>& scene, std::function<void(double)> progress)
      : StructureBuilder<Stored>(std::move(progress)), scene_(scene) {}
  Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) override {
    ProgressMonitor* const progress = &this->progress();
    if (options.kind == StructureKind::hierarchy)
      return build_hierarchy(scene_, layout, options.quality, progress);
    if (options.kind != StructureKind::uniform)
      return merged_grid(scene_, layout, overlap, options, progress);
    TbbExecutor executor{progress};
    return uniform_grid(executor, scene_, layout, overlap, options.max_references, options.max_map_words);
  }
  bool refit(const GridLayout& layout, Structure& hierarchy) override {
    return refit_hierarchy(scene_, layout, hierarchy);
  }
  const SceneView<Stored>& scene() const override { return scene_; }

private:
  SceneView<Stored> scene_;
};

} // namespace

template <class Stored>
std::unique_ptr<StructureBuilder<Stored>> cpu_builder(const SceneView<Stored>& scene,
                                                      std::function<void(double)> progress) {
  return std::make_unique<CpuBuilder<Stored>>(scene, std::move(progress));
}
template std::unique_ptr<StructureBuilder<float>> cpu_builder(const SceneView<float>&,
                                                              std::function<void(double)>);
template std::unique_ptr<StructureBuilder<double>> cpu_builder(const SceneView<double>&,
                                                               std::function<void(double)>);

} // namespace masu
