#include "libgrid/build/builder.h"

namespace masu {
namespace {

template <class Stored>
class CpuBuilder final : public GridBuilder<Stored> {
public:
  explicit CpuBuilder(const SceneView<Stored>& scene) : scene_(scene) {}
  Grid uniform(const GridLayout& layout, Overlap overlap) override {
    return build_uniform(scene_, layout, overlap);
  }
  Grid merged(const GridLayout& layout, Overlap overlap, const MergeRule& rule) override {
    return build_merged(scene_, layout, overlap, rule);
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
