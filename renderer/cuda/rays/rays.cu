#include "renderer/cuda/ray_batch.h"

namespace masu {
namespace {

// Rays in device memory as they are traced, aligned for the kernels' loads: where they lie, or copied.
template <class Real, class Stored>
const Ray<Real>* converted(const RayList& list, const Box<Stored>& box, const StreamMemory& memory,
                           DeviceArray<Ray<Real>>& copy) {
  if (is_own<Real>(list.format) && reinterpret_cast<std::uintptr_t>(list.rays) % alignof(Ray<Real>) == 0)
    return static_cast<const Ray<Real>*>(list.rays);
  copy = DeviceArray<Ray<Real>>(list.count, memory);
  const void* const rays = list.rays;
  const RayFormat format = list.format;
  Ray<Real>* const to = copy.data();
  for_each_on_device(list.count, memory.stream,
                     [=] __device__(std::uint64_t i) { to[i] = listed_ray<Real>(rays, format, i, box).ray; });
  return to;
}

// to_list() of traced rays, with `row` elements each.
template <class Real, class Stored>
void launch_to_list(const RayList& list, const Box<Stored>& box, const RayResults& results, std::uint32_t row,
                    const StreamMemory& memory) {
  const bool may_be_skipped =
      may_be_rounded<Real>(list.format) && (results.t != nullptr || results.t64 != nullptr);
  if (!may_be_skipped && results.position == nullptr) return;
  const void* const rays = list.rays;
  const RayFormat format = list.format;
  for_each_on_device(list.count, memory.stream, [=] __device__(std::uint64_t i) {
    to_list(listed_ray<Real>(rays, format, i, box).skipped, format.origin, results, i * row, row);
  });
}

} // namespace

KernelSize launch_rays(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                       const RaysRequest& request, Counts* counts, cudaStream_t stream, cudaEvent_t begun) {
  KernelSize size{};
  if (rays.count == 0) return size;
  if (request.query == Query::closest_point) return launch_closest(files, rays, results, stream, begun);
  const StreamMemory memory{stream, files.memory->pool};
  files.with_arithmetic(
      request.tracing.precision,
      [&]<class TestRay, class Stored>(const DeviceFilesOf<Stored>& stored, Arithmetic<TestRay>) {
        using Real = typename TestRay::Real;
        DeviceArray<Ray<Real>> copy;
        const Box<Stored> box = stored.scene.view.clip;
        const Ray<Real>* const own = converted(rays, box, memory, copy);
        const bool is_placed = stored.placements != nullptr,
                   in_order = needs_hits_in_order(rays, results, request),
                   is_named = request.query == Query::nearest_hit && !in_order &&
                              (results.has_attributes() || (is_placed && results.primitive != nullptr));
        const DeviceArray<float> t(is_named && results.t == nullptr ? rays.count : 0, memory);
        const DeviceArray<std::uint32_t> primitive(is_named && results.primitive == nullptr ? rays.count : 0,
                                                   memory);
        RayResults found = results;
        if (t.data() != nullptr) found.t = t.data();
        if (primitive.data() != nullptr) found.primitive = primitive.data();
        const RayBatch<Real> batch{own, rays.count, found, counts, memory, begun};
        if constexpr (!std::is_same_v<TestRay, TextbookRay>) {
          if (is_placed) size = launch_placed<TestRay>(stored, rays, request, batch, results);
          if (in_order && !is_placed)
            size = launch_hits<TestRay>(stored, hit_rules(request), rays.filters, batch);
        }
        if (!in_order && !is_placed) {
          size = launch_batch<TestRay>(stored, request, batch);
          if (is_named) launch_attributes(stored, batch, results);
        }
        if (request.query != Query::occlusion)
          launch_to_list<Real>(rays, box, results, hit_rules(request).row(), memory);
      });
  return size;
}

QueryReport launch_rays_cuda(const DeviceFiles& files, const RayList& rays, const RayResults& results,
                             const RaysRequest& request, void* stream) {
  const DeviceScope device(files.memory->device);
  QueryReport report;
  report.kernel = launch_rays(files, rays, results, request, nullptr, static_cast<cudaStream_t>(stream));
  return report;
}

QueryReport time_rays_cuda(const DeviceFiles& files, const ResidentRays& rays, const RaysRequest& request) {
  const DeviceScope device(files.memory->device);
  QueryReport report;
  const DeviceArray<Counts> counts(&report.counts, files.are_counted(request.tracing) ? 1 : 0,
                                   {nullptr, files.memory->pool});
  const DeviceTimer timer;
  report.kernel = launch_rays(files, rays.list, rays.results, request, counts.data(), nullptr, timer.start());
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
