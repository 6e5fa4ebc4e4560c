// Stands in for the CUDA backend where the program was built without it.
#include "renderer/backend.h"

#include "libscene/base/error.h"
#include "renderer/tracer/placed_tracer.h"

namespace masu {
namespace {

[[noreturn]] void refuse() {
  std::string why;
  static_cast<void>(cuda_available(why));
  throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu, or build where nvcc is on the PATH");
}

} // namespace

void set_up_cuda(int) {
  refuse();
}
std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile&, const StructureFile*, int) {
  refuse();
}
std::shared_ptr<const DeviceFiles> built_files_cuda(const SceneFile&, int, const ProgressMonitor*) {
  refuse();
}
Structure built_hierarchy_cuda(const DeviceFiles&) {
  refuse();
}
std::shared_ptr<const DeviceFiles> moved_files_cuda(const DeviceFiles&, const Vec3d&, const Vertices&) {
  refuse();
}
std::shared_ptr<const DeviceFiles> upload_placed_cuda(const AnyPlacedOnHost&, int) {
  refuse();
}
std::shared_ptr<const DeviceFiles> placed_files_cuda(const DeviceFiles&, const PlacementMoves&) {
  refuse();
}
unsigned kinds_on(const DeviceFiles&) {
  refuse();
}
std::shared_ptr<std::uint8_t> uploaded_cuda(std::span<const std::uint8_t>, int) {
  refuse();
}
void render_cuda(const DeviceFiles&, const FrameRequest&, Frame&) {
  refuse();
}
QueryReport trace_rays_cuda(const DeviceFiles&, const RayList&, const RayResults&, const RaysRequest&,
                            std::atomic<std::size_t>&) {
  refuse();
}
QueryReport launch_rays_cuda(const DeviceFiles&, const RayList&, const RayResults&, const RaysRequest&,
                             void*) {
  refuse();
}
QueryReport time_rays_cuda(const DeviceFiles&, const ResidentRays&, const RaysRequest&) {
  refuse();
}
void interpolate_cuda(const CornerValues&, const InterpolatedHits&, std::size_t, int, void*) {
  refuse();
}

} // namespace masu
