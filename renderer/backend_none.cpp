// Stands in for the CUDA backend where the program was built without it.
#include "renderer/backend.h"

#include "libscene/error.h"

namespace masu {
namespace {

[[noreturn]] void refuse() {
  std::string why;
  static_cast<void>(cuda_available(why));
  throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu, or build where nvcc is on the PATH");
}

} // namespace

Frame render_cuda(const SceneFile&, const GridFile*, const FrameRequest&) {
  refuse();
}
RayHits trace_rays_cuda(const SceneFile&, const GridFile*, const RaysRequest&) {
  refuse();
}
double upload_cuda(const SceneFile&, const GridFile*, const std::function<void()>&) {
  refuse();
}

} // namespace masu
