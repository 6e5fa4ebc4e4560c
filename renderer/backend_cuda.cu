#include "renderer/backend.h"

#include "renderer/arithmetic.h"
#include "renderer/device_scene.h"

namespace masu {

// backend_cuda_fast.cu, backend_cuda_robust.cu, backend_cuda_double.cu
template <class TestRay, class Stored>
void render_on_device(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& scene,
                      const GridFile* grid, const FrameRequest& request, Frame& frame);
template <class TestRay, class Stored>
void trace_on_device(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& scene, const GridFile* grid,
                     const ResidentRays& rays, const RaysRequest& request, RayHits& result);

void set_up_cuda() {
  std::string why;
  if (!cuda_available(why)) throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  // Memory that queries give back stays in the pool for the next one.
  int device = 0;
  cudaMemPool_t pool = nullptr;
  std::uint64_t all = ~std::uint64_t{0};
  check(cudaGetDevice(&device));
  check(cudaDeviceGetDefaultMemPool(&pool, device));
  check(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all));
}

std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile& scene, const GridFile* grid,
                                                     const std::function<void()>& meanwhile) {
  auto files = std::make_shared<DeviceFiles>();
  Transfer upload;
  if (scene.is_float64())
    files->float64.emplace(scene.view<double>(), grid, upload);
  else
    files->float32.emplace(scene.view<float>(), grid, upload);
  upload.run(meanwhile);
  return files;
}

namespace {

template <class Real>
DeviceArray<TypedRay<Real>> uploaded(std::span<const ListedRay> rays) {
  std::vector<TypedRay<Real>> typed_rays(rays.size());
  std::transform(rays.begin(), rays.end(), typed_rays.begin(), typed<Real>);
  return DeviceArray<TypedRay<Real>>(typed_rays.data(), typed_rays.size());
}

} // namespace

std::shared_ptr<const DeviceRays> upload_rays_cuda(std::span<const ListedRay> rays, bool as_double) {
  auto device = std::make_shared<DeviceRays>();
  if (as_double)
    device->float64 = uploaded<double>(rays);
  else
    device->float32 = uploaded<float>(rays);
  return device;
}

Frame render_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                  const FrameRequest& request) {
  Frame frame = empty_frame(request);
  with_store_and_arithmetic(
      scene, request.tracing.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        render_on_device<TestRay>(files.of<Stored>(), view, grid, request, frame);
      });
  return frame;
}

RayHits trace_rays_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                        const ResidentRays& rays, const RaysRequest& request) {
  RayHits result;
  result.hits.resize(rays.host.size());
  if (result.hits.empty()) return result;
  with_store_and_arithmetic(
      scene, request.tracing.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        trace_on_device<TestRay>(files.of<Stored>(), view, grid, rays, request, result);
      });
  return result;
}

} // namespace masu
