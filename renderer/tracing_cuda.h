// Tracing on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Each arithmetic's kernels are compiled in a source of their own (backend_cuda_*.cu), which instantiates
// render_on_device() and trace_on_device(): so that they are compiled at the same time.
#pragma once

#include "renderer/device_scene.h"
#include "renderer/warp_tracing_cuda.h"

namespace masu {

__device__ inline void add(Counts* total, const Counts& part) {
  if (total == nullptr) return;
  for (int i = 0; i < Counts::fields; ++i) {
    if (part.begin()[i] != 0)
      atomicAdd(reinterpret_cast<unsigned long long*>(total->begin() + i),
                static_cast<unsigned long long>(part.begin()[i]));
  }
}
__device__ inline void add(Counts*, const NoCounts&) {}

// The next tile of a worker, a block of threads: from left.end on there is none. `next` counts what all
// workers have fetched, where they fetch. Threads share what is left to them: they have no registers to
// spare.
__device__ inline std::uint32_t taken(TileRun& left, std::uint32_t* const next) {
  __shared__ std::uint32_t tile;
  __syncthreads(); // `left` is there, and all have read the last tile
  if (threadIdx.x == 0 && threadIdx.y == 0) {
    tile = next != nullptr ? atomicAdd(next, 1U) : left.first;
    left.first += left.step;
  }
  __syncthreads();
  return tile;
}

// The method as kernels have it. The same bits, but where there are cones, whose test leaves no registers for
// the plane across the ray, each triangle's test finds that for itself.
template <class M>
struct DeviceMethod {
  using type = M;
};
template <unsigned kinds, StopRule stop>
requires((kinds & with_cones) != 0) struct DeviceMethod<Method<WatertightRay<float>, kinds, stop>> {
  using type = Method<PreparedRay<float>, kinds, stop>;
};
template <class M>
using OnDevice = typename DeviceMethod<M>::type;

// A warp covers 8 × 4 rays of a tile: neighbours walk through the same cells. One kernel for all schedules,
// so that nothing else differs.
template <class M, class Stored, class Grid, class C>
__global__ void __launch_bounds__(tile_side* tile_side, resident_threads_wanted<M> / (tile_side * tile_side))
    render_kernel(const SceneView<Stored> scene, const Grid grid, const CameraRays<typename M::Real> rays,
                  const RenderRules rules, const Tiles tiles, const Schedule schedule,
                  std::uint32_t* const next_tile, Vec3f* const colors, HitRecord* const hits,
                  Counts* const total) {
  __shared__ TileRun left;
  if (threadIdx.x == 0 && threadIdx.y == 0) left = run_of(schedule, blockIdx.x, gridDim.x, tiles.count);
  C counts;
  for (std::uint32_t tile = taken(left, next_tile); tile < left.end; tile = taken(left, next_tile)) {
    const auto column = static_cast<std::int32_t>(tile % tiles.columns * tile_side + threadIdx.x);
    const auto row = static_cast<std::int32_t>(tile / tiles.columns * tile_side + threadIdx.y);
    if (column >= rays.columns || row >= rays.rows) continue;
    HitRecord hit{};
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.columns) +
                           static_cast<std::size_t>(column);
    colors[at] = radiance<M>(scene, grid, rules, camera_ray(rays, column, row), hit, counts);
    if (hits != nullptr) hits[at] = hit;
  }
  add(total, counts);
}

template <Query query, class M, class Stored, class Grid, class C>
__global__ void __launch_bounds__(rays_a_block, resident_threads_wanted<M> / rays_a_block)
    trace_kernel(const SceneView<Stored> scene, const Grid grid, const TypedRay<typename M::Real>* const rays,
                 const std::uint64_t count, const HitName name, HitRecord* const hits, Counts* const total) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_a_block + threadIdx.x;
  if (i >= count) return;
  C counts;
  hits[i] = trace_listed<query, M>(scene, grid, streamed(rays + i), name, counts);
  add(total, counts);
}

// Traces with rays of this arithmetic: a picture, a list of rays. Throw Error(device).
template <class TestRay, class Stored>
void render_on_device(const SceneView<Stored>& host_scene, const GridFile* host_grid,
                      const FrameRequest& request, Frame& frame) {
  DeviceArray<Vec3f> colors(frame.radiance.size());
  DeviceArray<HitRecord> hits(frame.hits.size());
  const DeviceArray<std::uint32_t> next_tile(1);
  const DeviceArray<Counts> total(&frame.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  const Uploaded<Stored> device(host_scene, host_grid, request.before_tracing);
  frame.seconds.upload = device.seconds;
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = device.grid.moved(view);
    const auto rays = camera_rays<typename M::Real>(request.camera, request.sampling, request.hither);
    const Tiles tiles = tiles_of(frame.columns, frame.rows);
    auto* const kernel = render_kernel<OnDevice<M>, Stored, std::decay_t<decltype(grid)>, C>;
    frame.workers =
        request.schedule == Schedule::hardware
            ? tiles.count
            : std::min(tiles.count, resident_blocks(kernel, tile_side * tile_side, request.workers_each));
    const bool fetch = request.schedule == Schedule::persistent;
    const auto reset = [&] { check(cudaMemsetAsync(next_tile.data(), 0, sizeof(std::uint32_t))); };
    frame.kernel = load(kernel);
    frame.seconds.trace = timed_launches(request.warm_up, request.repeat, reset, [&] {
      kernel<<<frame.workers, dim3(tile_side, tile_side)>>>(
          device.scene.view, grid, rays, request.rules, tiles, request.schedule,
          fetch ? next_tile.data() : nullptr, colors.data(), hits.data(), total.data());
    });
  });
  const Stopwatch watch;
  colors.download(frame.radiance.data());
  hits.download(frame.hits.data());
  total.download(&frame.counts);
  frame.seconds.download = watch.seconds();
}

// So many blocks have a thread for each ray.
inline unsigned blocks_of(int threads, std::size_t rays) {
  const auto each = static_cast<std::size_t>(threads);
  return static_cast<unsigned>((rays + each - 1) / each);
}

// Traces a list of rays by warp or refill (RayLoop). `rays` are those on the device, for a look at them.
template <Query query, class M, class Stored, class Grid>
void trace_by_warps(const SceneView<Stored>& host_scene, const SceneView<Stored>& scene, const Grid& grid,
                    std::span<const TypedRay<typename M::Real>> rays,
                    const DeviceArray<TypedRay<typename M::Real>>& device_rays, const RaysRequest& request,
                    DeviceArray<HitRecord>& hits, RayHits& result) {
  using Real = typename M::Real;
  const bool refills = request.loop == RayLoop::warp_refill;
  auto* const cull = cull_kernel<query, Real, Stored>;
  auto* const trace = warp_kernel<false, query, OnDevice<M>, Stored, Grid>;
  auto* const finish = warp_kernel<true, query, OnDevice<M>, Stored, Grid>;
  const unsigned blocks =
                     std::min(blocks_of(rays_a_block, rays.size()), resident_blocks(trace, rays_a_block, 0)),
                 finishing = std::max(blocks, resident_blocks(finish, rays_a_block, 0));
  const StragglerQueueMemory<Real> left(blocks * (rays_a_block / lanes_a_warp));
  const bool culls = refills && often_misses<query, Real>(host_scene, rays);
  const int fetches_at = culls ? some_fetch_chosen : refills ? some_fetch : all_fetch;
  const DeviceArray<std::uint32_t> chosen(culls ? rays.size() : 0);
  const DeviceArray<std::uint32_t> chosen_count(1);
  RayList<Real> list{device_rays.data(), static_cast<std::uint32_t>(rays.size()), nullptr, nullptr};
  if (culls) list = {list.rays, list.count, chosen.data(), chosen_count.data()};
  load(cull);
  load(finish);
  result.kernel = load(trace);
  const auto reset = [&] {
    left.reset();
    check(cudaMemsetAsync(chosen_count.data(), 0, sizeof(std::uint32_t)));
  };
  result.seconds.trace = timed_launches(request.warm_up, request.repeat, reset, [&] {
    const HitName name = request.hit_name;
    if (culls)
      cull<<<blocks_of(rays_a_culling_block, rays.size()), rays_a_culling_block>>>(
          scene, list.rays, list.count, name, hits.data(), chosen.data(), chosen_count.data());
    trace<<<blocks, rays_a_block>>>(scene, grid, list, fetches_at, name, hits.data(), left.view());
    finish<<<finishing, rays_a_block>>>(scene, grid, list, fetches_at, name, hits.data(), left.view());
  });
}

template <class TestRay, class Stored>
void trace_on_device(const SceneView<Stored>& host_scene, const GridFile* host_grid,
                     const RaysRequest& request, RayHits& result) {
  using Real = typename TestRay::Real;
  std::vector<TypedRay<Real>> rays(request.rays.size());
  std::transform(request.rays.begin(), request.rays.end(), rays.begin(), typed<Real>);
  Stopwatch watch;
  const DeviceArray<TypedRay<Real>> device_rays(rays.data(), rays.size());
  DeviceArray<HitRecord> hits(rays.size());
  const DeviceArray<Counts> total(&result.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  result.seconds.upload = watch.seconds();
  const Uploaded<Stored> device(host_scene, host_grid, request.before_tracing);
  result.seconds.upload += device.seconds;
  if (rays.empty()) return;
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = device.grid.moved(view);
    using Accelerator = std::decay_t<decltype(grid)>;
    with_query(request.query, [&]<Query query>(Asked<query>) {
      const auto& scene = device.scene.view;
      if constexpr (std::is_same_v<C, NoCounts> && !std::is_same_v<Accelerator, NoGrid> &&
                    M::stop == StopRule::proven) {
        if (request.loop != RayLoop::thread_per_ray && rays.size() <= most_rays_by_warps)
          return trace_by_warps<query, M>(host_scene, scene, grid, rays, device_rays, request, hits, result);
      }
      auto* const kernel = trace_kernel<query, OnDevice<M>, Stored, Accelerator, C>;
      result.kernel = load(kernel);
      const auto nothing = [] {};
      result.seconds.trace = timed_launches(request.warm_up, request.repeat, nothing, [&] {
        kernel<<<blocks_of(rays_a_block, rays.size()), rays_a_block>>>(
            scene, grid, device_rays.data(), rays.size(), request.hit_name, hits.data(), total.data());
      });
    });
  });
  watch = Stopwatch();
  hits.download(result.hits.data());
  total.download(&result.counts);
  result.seconds.download = watch.seconds();
}

} // namespace masu
