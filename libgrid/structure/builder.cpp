#include "libgrid/structure/builder.h"

#include "libgrid/grid/merge.h"
#include "libgrid/grid/uniform_passes.h"
#include "libgrid/hierarchy/hierarchy_builder.h"
#include "libscene/passes/host_executor.h"

#include <utility>

namespace masu {

namespace {

template <class Stored>
class CpuBuilder final : public StructureBuilder<Stored> {
public:
  using StructureBuilder<Stored>::StructureBuilder;
  Structure try_build(const GridLayout& layout, Overlap overlap, const StructureOptions& options) override {
    const SceneView<Stored>& scene = this->scene();
    ProgressMonitor* const progress = &this->progress();
    if (options.kind == StructureKind::hierarchy)
      return build_hierarchy(scene, layout, options.quality, progress);
    if (options.kind != StructureKind::uniform) return merged_grid(scene, layout, overlap, options, progress);
    TbbExecutor executor{progress};
    return uniform_grid(executor, scene, layout, overlap, options.max_references, options.max_map_words);
  }
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
