#include "libgrid/build/builder.h"

#include "libgrid/build/merge.h"
#include "libscene/error.h"

#include <fmt/format.h>

namespace masu {

template <class Stored>
Grid GridBuilder<Stored>::build(const GridLayout& layout, Overlap overlap, const GridOptions& options) {
  BuildResult result = try_build(layout, overlap, options);
  if (result.exceeded != nullptr)
    throw Error(ErrorCode::usage, "division", fmt::format("makes {}: choose a coarser one", result.exceeded));
  return std::move(result.grid);
}
template class GridBuilder<float>;
template class GridBuilder<double>;

namespace {

template <class Stored>
class CpuBuilder final : public GridBuilder<Stored> {
public:
  explicit CpuBuilder(const SceneView<Stored>& scene) : scene_(scene) {}
  BuildResult try_build(const GridLayout& layout, Overlap overlap, const GridOptions& options) override {
    return options.kind == GridKind::uniform ? uniform_grid(scene_, layout, overlap)
                                             : merged_grid(scene_, layout, overlap, options);
  }
  const SceneView<Stored>& scene() const override { return scene_; }

private:
  SceneView<Stored> scene_;
};

} // namespace

template <class Stored>
std::unique_ptr<GridBuilder<Stored>> cpu_builder(const SceneView<Stored>& scene) {
  return std::make_unique<CpuBuilder<Stored>>(scene);
}
template std::unique_ptr<GridBuilder<float>> cpu_builder(const SceneView<float>&);
template std::unique_ptr<GridBuilder<double>> cpu_builder(const SceneView<double>&);

} // namespace masu
