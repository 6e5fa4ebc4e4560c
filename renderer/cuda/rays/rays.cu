#include "renderer/cuda/ray_batch.h"

namespace masu {
LaunchRays* launcher_of(const DeviceFiles& files, const RaysRequest& request) {
  constexpr ByArithmetic launch_lists{
      launch_list<TextbookRay, float>, launch_list<WatertightRay<float>, float>,
      launch_list<WatertightRay<double>, float>, launch_list<WatertightRay<double>, double>};
  return request.query == Query::closest_point ? launch_closest
                                               : launch_lists.of(files, request.tracing.precision);
}

QueryReport launch_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                             const RaysRequest& request, void* stream) {
  const DeviceScope device(files.memory->device);
  QueryReport report;
  if (rays.count > 0)
    report.kernel = launcher_of(files, request)(files, rays, results, request, nullptr,
                                                static_cast<cudaStream_t>(stream), nullptr);
  return report;
}

QueryReport time_rays_cuda(const DeviceFiles& files, const ResidentRays& rays, const RaysRequest& request) {
  const DeviceScope device(files.memory->device);
  QueryReport report;
  const DeviceArray<Counts> counts(&report.counts, files.are_counted(request.tracing) ? 1 : 0,
                                   {nullptr, files.memory->pool});
  const DeviceTimer timer;
  if (rays.list.count > 0)
    report.kernel = launcher_of(files, request)(files, rays.list, rays.results, request, counts.data(),
                                                nullptr, timer.start());
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
                                           rays.count * rays.format.bytes_per_ray());
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
