#include "renderer/backend.h"

#include "renderer/arithmetic.h"
#include "renderer/queue_cuda.h"

namespace masu {

void set_up_cuda(int device) {
  std::string why;
  if (!cuda_available(why)) throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  const DeviceScope scope(device);
  // Memory that queries give back stays in the pool for the next one.
  cudaMemPool_t pool = nullptr;
  std::uint64_t all = ~std::uint64_t{0};
  check(cudaDeviceGetDefaultMemPool(&pool, device));
  check(cudaMemPoolSetAttribute(pool, cudaMemPoolAttrReleaseThreshold, &all));
}

std::shared_ptr<const DeviceFiles> upload_files_cuda(const SceneFile& scene, const GridFile* grid, int device,
                                                     const std::function<void()>& meanwhile) {
  const DeviceScope scope(device);
  auto files = std::make_shared<DeviceFiles>();
  files->device = device;
  Transfer upload;
  if (scene.is_float64())
    files->float64.emplace(scene.view<double>(), grid, upload);
  else
    files->float32.emplace(scene.view<float>(), grid, upload);
  upload.run(meanwhile);
  if (files->float32) files->float32->make_leaves(grid);
  if (files->float64) files->float64->make_leaves(grid);
  return files;
}

void render_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                 const FrameRequest& request, Frame& frame) {
  const DeviceScope device(files.device);
  const auto buffers = files.frames.borrow();
  with_store_and_arithmetic(
      scene, request.tracing.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        render_on_device<TestRay>(files.of<Stored>(), view, grid, request, *buffers, frame);
      });
}

namespace {

constexpr int rays_a_converting_block = 256;

template <class Real>
__global__ void __launch_bounds__(rays_a_converting_block)
    convert_kernel(const void* const rays, const RayFormat format, const std::uint64_t count,
                   Ray<Real>* const converted) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_a_converting_block + threadIdx.x;
  if (i < count) converted[i] = loaded<Real>(rays, format, i);
}

// Rays in device memory as the arithmetic's numbers, aligned for its loads: where they lie, or copied.
template <class Real>
struct ConvertedRays {
  DeviceArray<Ray<Real>> copy;
  const Ray<Real>* rays;

  ConvertedRays(const RayList& list, cudaStream_t stream) : rays(static_cast<const Ray<Real>*>(list.rays)) {
    if (list.format == own_format<Real> &&
        reinterpret_cast<std::uintptr_t>(list.rays) % alignof(Ray<Real>) == 0)
      return;
    copy = DeviceArray<Ray<Real>>(list.count, stream);
    rays = copy.data();
    const auto blocks =
        static_cast<unsigned>((list.count + rays_a_converting_block - 1) / rays_a_converting_block);
    convert_kernel<<<blocks, rays_a_converting_block, 0, stream>>>(list.rays, list.format, list.count,
                                                                   copy.data());
    check(cudaGetLastError());
  }
};

} // namespace

KernelSize queue_rays(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                      const RayList& rays, const RayResults& results, const RaysRequest& request,
                      Counts* counts, cudaStream_t stream, cudaEvent_t begun) {
  KernelSize size{};
  if (rays.count == 0) return size;
  with_store_and_arithmetic(
      scene, request.tracing.precision,
      [&]<class TestRay, class Stored>(const SceneView<Stored>& view, Arithmetic<TestRay>) {
        using Real = typename TestRay::Real;
        const ConvertedRays<Real> converted(rays, stream);
        const bool has_attributes = request.query == Query::nearest_hit && results.has_attributes();
        const DeviceArray<float> t(has_attributes && results.t == nullptr ? rays.count : 0, stream);
        const DeviceArray<std::uint32_t> primitive(
            has_attributes && results.primitive == nullptr ? rays.count : 0, stream);
        RayResults found = results;
        if (t.data() != nullptr) found.t = t.data();
        if (primitive.data() != nullptr) found.primitive = primitive.data();
        const RayBatch<Real> batch{converted.rays, rays.count, found, counts, stream, begun};
        size = queue_batch<TestRay>(files.of<Stored>(), view, grid, request, batch);
        if (has_attributes) queue_attributes(files.of<Stored>(), batch, results);
      });
  return size;
}

QueryReport queue_rays_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                            const RayList& rays, const RayResults& results, const RaysRequest& request,
                            void* stream) {
  const DeviceScope device(files.device);
  QueryReport report;
  report.kernel =
      queue_rays(files, scene, grid, rays, results, request, nullptr, static_cast<cudaStream_t>(stream));
  return report;
}

QueryReport time_rays_cuda(const DeviceFiles& files, const SceneFile& scene, const GridFile* grid,
                           const ResidentRays& rays, const RaysRequest& request) {
  const DeviceScope device(files.device);
  QueryReport report;
  const DeviceArray<Counts> counts(&report.counts, request.tracing.count || grid == nullptr ? 1 : 0);
  const DeviceTimer timer;
  report.kernel =
      queue_rays(files, scene, grid, rays.list, rays.results, request, counts.data(), nullptr, timer.start());
  report.seconds.trace = timer.seconds();
  counts.download(&report.counts);
  return report;
}

ResidentRays upload_rays_cuda(const RayList& rays, int device) {
  const DeviceScope scope(device);
  struct Memory {
    DeviceArray<std::uint8_t> rays;
    DeviceArray<float> t;
    DeviceArray<std::uint32_t> primitive;
    DeviceArray<std::uint8_t> occluded;
  };
  const auto memory = std::make_shared<Memory>();
  memory->rays = DeviceArray<std::uint8_t>(static_cast<const std::uint8_t*>(rays.rays),
                                           rays.count * rays.format.bytes_a_ray());
  memory->t = DeviceArray<float>(rays.count);
  memory->primitive = DeviceArray<std::uint32_t>(rays.count);
  memory->occluded = DeviceArray<std::uint8_t>(rays.count);
  check(cudaStreamSynchronize(nullptr)); // the rays are copied
  ResidentRays resident{RayList(memory->rays.data(), rays.count, rays.format), {}, memory};
  resident.results.t = memory->t.data();
  resident.results.primitive = memory->primitive.data();
  resident.results.occluded = memory->occluded.data();
  return resident;
}

} // namespace masu
