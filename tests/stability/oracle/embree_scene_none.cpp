// Where this program was built without Embree.
#include "libscene/base/error.h"
#include "stability/oracle/embree_scene.h"

namespace masu {

const bool embree_available = false;

std::string embree_name() {
  return "Embree";
}

EmbreeScene::EmbreeScene(const SceneView<float>&, EmbreeFlags) {
  throw Error(ErrorCode::usage, "Embree", "this program was built without it: install libembree-dev");
}
EmbreeScene::~EmbreeScene() = default;

void EmbreeScene::trace(std::span<const Ray<float>>, float*, PrimitiveIndex*) const {}
void EmbreeScene::trace_packets(std::span<const Ray<float>>, float*, PrimitiveIndex*) const {}

} // namespace masu
