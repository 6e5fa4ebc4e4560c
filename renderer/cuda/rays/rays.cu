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

std::shared_ptr<std::uint8_t> uploaded_cuda(std::span<const std::uint8_t> bytes, int device) {
  const DeviceScope scope(device);
  const auto memory = std::make_shared<DeviceArray<std::uint8_t>>(bytes.data(), bytes.size());
  check(cudaStreamSynchronize(nullptr)); // they are copied
  return {memory, memory->data()};
}

void interpolate_cuda(const CornerValues& values, const InterpolatedHits& hits, std::size_t count, int device,
                      void* stream) {
  const DeviceScope scope(device);
  for_each_on_device(count * values.width, static_cast<cudaStream_t>(stream),
                     [=] __device__(std::uint64_t n) {
                       hits.results[n] = interpolated(values, hits, n / values.width, n % values.width);
                     });
}

} // namespace masu
