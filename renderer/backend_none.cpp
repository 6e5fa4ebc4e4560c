// Stands in for the CUDA backend where the program was built without it.
#include "renderer/backend.h"

#include "libscene/error.h"
#include "renderer/plain_copy.h"

namespace masu {
namespace {

constexpr const char* reason = "this program was built without CUDA";

[[noreturn]] void refuse() {
  throw Error(ErrorCode::device, "cuda",
              std::string(reason) + ": use --backend cpu, or build where nvcc is on the PATH");
}

} // namespace

bool cuda_available(std::string& why) {
  why = reason;
  return false;
}
Frame render_cuda(const SceneFile&, const GridFile*, const FrameRequest&) {
  refuse();
}
RayHits trace_rays_cuda(const SceneFile&, const GridFile*, const RaysRequest&) {
  refuse();
}
double upload_cuda(const SceneFile&, const GridFile*) {
  refuse();
}
double copy_seconds_cuda(const std::string&, CopyFrom) {
  refuse();
}

} // namespace masu
