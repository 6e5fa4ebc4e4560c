// Stands in for the CUDA builder where the program was built without it.
#include "libgrid/structure/builder.h"

#include "libscene/base/error.h"
#include "libscene/cuda/cuda_device.h"

namespace masu {

template <class Stored>
std::unique_ptr<StructureBuilder<Stored>>
cuda_builder(const SceneView<Stored>&, int, std::function<void(double)>, bool, const UnmadeTriangles*) {
  std::string why;
  static_cast<void>(cuda_available(why));
  throw Error(ErrorCode::device, "cuda", why + ": build on the CPU, or compile where nvcc is on the PATH");
}
template std::unique_ptr<StructureBuilder<float>>
cuda_builder(const SceneView<float>&, int, std::function<void(double)>, bool, const UnmadeTriangles*);
template std::unique_ptr<StructureBuilder<double>>
cuda_builder(const SceneView<double>&, int, std::function<void(double)>, bool, const UnmadeTriangles*);

} // namespace masu
