// Tracing on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Each arithmetic's kernels are compiled in a source of their own (backend_cuda_*.cu), which instantiates
// render_on_device() and trace_on_device(): so that they are compiled at the same time.
#pragma once

#include "libscene/stopwatch.h"
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

// A block of threads traces a tile of 8 x 8 rays, a warp 8 x 4 of them: neighbours visit the same cells.
inline constexpr int tile_side = 8;

template <class M, class Stored, class Grid, class C>
__global__ void __launch_bounds__(tile_side* tile_side, resident_threads_wanted<M> / (tile_side * tile_side))
    render_kernel(const SceneView<Stored> scene, const Grid grid, const CameraRays<typename M::Real> rays,
                  const RenderRules rules, Vec3f* const colors, HitRecord* const hits, Counts* const total) {
  const auto column = static_cast<std::int32_t>(blockIdx.x * tile_side + threadIdx.x);
  const auto row = static_cast<std::int32_t>(blockIdx.y * tile_side + threadIdx.y);
  if (column >= rays.columns || row >= rays.rows) return;
  C counts;
  HitRecord hit{};
  const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.columns) +
                            static_cast<std::size_t>(column);
  colors[index] = radiance<M>(scene, grid, rules, camera_ray(rays, column, row), hit, counts);
  if (hits != nullptr) hits[index] = hit;
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
void render_on_device(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& host_scene,
                      const GridFile* host_grid, const FrameRequest& request, Frame& frame) {
  const PooledArray<Vec3f> colors(frame.radiance.size());
  const PooledArray<HitRecord> hits(frame.hits.size());
  const DeviceArray<Counts> total(&frame.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = files.grid.moved(view);
    const auto rays =
        camera_rays<typename M::Real>(request.camera, request.sampling, request.hither, request.window);
    const auto tiles = [](std::int32_t side) {
      return static_cast<unsigned>((side + tile_side - 1) / tile_side);
    };
    auto* const kernel = render_kernel<OnDevice<M>, Stored, std::decay_t<decltype(grid)>, C>;
    frame.kernel = load(kernel);
    frame.seconds.trace = timed([&] {
      kernel<<<dim3(tiles(frame.columns), tiles(frame.rows)), dim3(tile_side, tile_side)>>>(
          files.scene.view, grid, rays, request.rules, colors.data(), hits.data(), total.data());
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

// Occlusion by other arithmetics than `robust` is always traced by a thread a ray: it isn't worth their
// kernels.
template <Query query, class TestRay>
constexpr bool has_warp_loops = query == Query::nearest_hit || std::is_same_v<TestRay, WatertightRay<float>>;

// Traces a list of rays by warp or warp_refill (RayLoop).
template <Query query, class M, class Stored, class Grid>
void trace_by_warps(const SceneView<Stored>& host_scene, const SceneView<Stored>& scene, const Grid& grid,
                    const ResidentRays& rays, const RaysRequest& request, const PooledArray<HitRecord>& hits,
                    RayHits& result) {
  using Real = typename M::Real;
  const DeviceArray<TypedRay<Real>>& device_rays = rays.device->of<Real>();
  const std::size_t count = device_rays.size();
  const bool refills = request.loop == RayLoop::warp_refill;
  auto* const cull = cull_kernel<query, Real, Stored>;
  auto* const trace = warp_kernel<false, query, OnDevice<M>, Stored, Grid>;
  auto* const finish = warp_kernel<true, query, OnDevice<M>, Stored, Grid>;
  const unsigned blocks = std::min(blocks_of(rays_a_block, count), resident_blocks(trace, rays_a_block, 0)),
                 finishing = std::max(blocks, resident_blocks(finish, rays_a_block, 0));
  const StragglerQueueMemory<Real> left(blocks * (rays_a_block / lanes_a_warp));
  const bool culls = refills && often_misses<query, Real>(host_scene, rays.host);
  const int fetches_at = culls ? some_fetch_chosen : refills ? some_fetch : all_fetch;
  const PooledArray<std::uint32_t> chosen(culls ? count : 0);
  const PooledArray<std::uint32_t> chosen_count(1);
  RayList<Real> list{device_rays.data(), static_cast<std::uint32_t>(count), nullptr, nullptr};
  if (culls) list = {list.rays, list.count, chosen.data(), chosen_count.data()};
  load(cull);
  load(finish);
  result.kernel = load(trace);
  left.reset();
  check(cudaMemsetAsync(chosen_count.data(), 0, sizeof(std::uint32_t)));
  result.seconds.trace = timed([&] {
    const HitName name = request.hit_name;
    if (culls)
      cull<<<blocks_of(rays_a_culling_block, count), rays_a_culling_block>>>(
          scene, list.rays, list.count, name, hits.data(), chosen.data(), chosen_count.data());
    trace<<<blocks, rays_a_block>>>(scene, grid, list, fetches_at, name, hits.data(), left.view());
    finish<<<finishing, rays_a_block>>>(scene, grid, list, fetches_at, name, hits.data(), left.view());
  });
}

template <class TestRay, class Stored>
void trace_on_device(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& host_scene,
                     const GridFile* host_grid, const ResidentRays& rays, const RaysRequest& request,
                     RayHits& result) {
  using Real = typename TestRay::Real;
  const DeviceArray<TypedRay<Real>>& device_rays = rays.device->of<Real>();
  const PooledArray<HitRecord> hits(device_rays.size());
  const DeviceArray<Counts> total(&result.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = files.grid.moved(view);
    using Accelerator = std::decay_t<decltype(grid)>;
    with_query(request.query, [&]<Query query>(Asked<query>) {
      const auto& scene = files.scene.view;
      // Any hit is as good as another: the rule by which a search for the nearest one ends doesn't matter.
      using Used = std::conditional_t<query == Query::occlusion, Method<TestRay, M::kinds>, M>;
      if constexpr (std::is_same_v<C, NoCounts> && !std::is_same_v<Accelerator, NoGrid> &&
                    M::stop == StopRule::proven && has_warp_loops<query, TestRay>) {
        if (request.loop != RayLoop::thread_per_ray && device_rays.size() <= most_rays_by_warps)
          return trace_by_warps<query, M>(host_scene, scene, grid, rays, request, hits, result);
      }
      auto* const kernel = trace_kernel<query, OnDevice<Used>, Stored, Accelerator, C>;
      result.kernel = load(kernel);
      result.seconds.trace = timed([&] {
        kernel<<<blocks_of(rays_a_block, device_rays.size()), rays_a_block>>>(
            scene, grid, device_rays.data(), device_rays.size(), request.hit_name, hits.data(), total.data());
      });
    });
  });
  const Stopwatch watch;
  hits.download(result.hits.data());
  total.download(&result.counts);
  result.seconds.download = watch.seconds();
}

} // namespace masu
