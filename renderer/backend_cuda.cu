#include "renderer/arithmetic.h"
#include "renderer/backend.h"
#include "renderer/device_scene.h"

namespace masu {

// backend_cuda_fast.cu, backend_cuda_robust.cu, backend_cuda_double.cu
template <class TestRay, class Stored>
void render_on_device(const SceneView<Stored>& scene, const GridFile* grid, const FrameRequest& request,
                      Frame& frame);
template <class TestRay, class Stored>
void trace_on_device(const SceneView<Stored>& scene, const GridFile* grid, const RaysRequest& request,
                     RayHits& result);

double upload_cuda(const SceneFile& scene, const GridFile* grid, const std::function<void()>& meanwhile) {
  check(cudaFree(nullptr)); // sets the device up, so that uploading isn't charged for it
  return scene.is_float64() ? Uploaded<double>(scene.view<double>(), grid, meanwhile).seconds
                            : Uploaded<float>(scene.view<float>(), grid, meanwhile).seconds;
}

Frame render_cuda(const SceneFile& scene, const GridFile* grid, const FrameRequest& request) {
  Frame frame = empty_frame(request);
  check(cudaFree(nullptr)); // sets the device up, so that uploading isn't charged for it
  with_store_and_arithmetic(scene, request.tracing.precision,
                            [&]<class TestRay>(const auto& view, Arithmetic<TestRay>) {
                              render_on_device<TestRay>(view, grid, request, frame);
                            });
  return frame;
}

RayHits trace_rays_cuda(const SceneFile& scene, const GridFile* grid, const RaysRequest& request) {
  RayHits result;
  result.hits.resize(request.rays.size());
  check(cudaFree(nullptr));
  with_store_and_arithmetic(scene, request.tracing.precision,
                            [&]<class TestRay>(const auto& view, Arithmetic<TestRay>) {
                              trace_on_device<TestRay>(view, grid, request, result);
                            });
  return result;
}

} // namespace masu
