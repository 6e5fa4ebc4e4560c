// Tracing on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Each arithmetic's kernels are compiled in a source of their own (backend_cuda_*.cu), which instantiates
// render_on_device() and trace_on_device(): so that they are compiled at the same time.
#pragma once

#include "renderer/device_scene.h"
#include "renderer/dispatch.h"

namespace masu {

constexpr int rays_a_block = 128;

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

// Threads that should fit on a multiprocessor: the compiler may spend registers only so far. Double takes
// twice as many.
template <class M>
constexpr int resident_threads_wanted = sizeof(typename M::Real) == 4 ? 1024 : 512;

// A warp covers 8 × 4 rays of a tile: neighbours walk through the same cells. One kernel for all schedules,
// so that nothing else differs.
template <class M, class Stored, class Grid, class C>
__global__ void __launch_bounds__(tile_side* tile_side, resident_threads_wanted<M> / (tile_side * tile_side))
    render_kernel(const SceneView<Stored> scene, const Grid grid, const EyeRays<typename M::Real> rays,
                  const RenderRules rules, const Tiles tiles, const Schedule schedule,
                  std::uint32_t* const next_tile, Vec3f* const colors, EyeHit* const hits,
                  Counts* const total) {
  __shared__ TileRun left;
  if (threadIdx.x == 0 && threadIdx.y == 0) left = run_of(schedule, blockIdx.x, gridDim.x, tiles.count);
  C counts;
  for (std::uint32_t tile = taken(left, next_tile); tile < left.end; tile = taken(left, next_tile)) {
    const auto column = static_cast<std::int32_t>(tile % tiles.columns * tile_side + threadIdx.x);
    const auto row = static_cast<std::int32_t>(tile / tiles.columns * tile_side + threadIdx.y);
    if (column >= rays.columns || row >= rays.rows) continue;
    EyeHit hit{};
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.columns) +
                           static_cast<std::size_t>(column);
    colors[at] = radiance<M>(scene, grid, rules, eye_ray(rays, column, row), hit, counts);
    if (hits != nullptr) hits[at] = hit;
  }
  add(total, counts);
}

template <Question question, class M, class Stored, class Grid, class C>
__global__ void __launch_bounds__(rays_a_block, resident_threads_wanted<M> / rays_a_block)
    trace_kernel(const SceneView<Stored> scene, const Grid grid, const TypedRay<typename M::Real>* const rays,
                 const std::uint64_t count, const HitName name, EyeHit* const hits, Counts* const total) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_a_block + threadIdx.x;
  if (i >= count) return;
  C counts;
  hits[i] = trace_listed<question, M>(scene, grid, rays[i], name, counts);
  add(total, counts);
}

// What a ray's hit is told with when it is found, and where: kept in shared memory, since it is needed once.
template <class Real>
struct RayEnds {
  Real scale, skipped, t_max;
  std::uint64_t number;
};

// Warps whose lanes take a step and a few tests each a turn: one with a long list doesn't hold up the others.
// Lanes that are done wait for the last one of their warp; or, if it `refills`, warps live until no ray is
// left, and when enough lanes are done they fetch as many rays at once, after Aila & Laine, "Understanding
// the Efficiency of Ray Traversal on GPUs", HPG 2009. `next` counts rays fetched.
template <bool refills, Question question, class M, class Stored, class Grid>
__global__ void __launch_bounds__(rays_a_block, resident_threads_wanted<M> / rays_a_block)
    turns_kernel(const SceneView<Stored> scene, const Grid grid, const TypedRay<typename M::Real>* const rays,
                 const std::uint64_t count, const HitName name, EyeHit* const hits,
                 unsigned long long* const next) {
  using Real = typename M::Real;
  constexpr unsigned all_lanes = 0xffffffffU;
  constexpr int enough = refills ? 12 : 32, tests_a_turn = refills ? 3 : 8;
  const unsigned lane = threadIdx.x % 32;
  __shared__ RayEnds<Real> ends[rays_a_block];
  RayEnds<Real>& own = ends[threadIdx.x];
  NoCounts counts;
  // All in variables of the kernel's own: what holds references to itself would not stay in registers.
  typename M::TestRay test_ray{};
  VisitorFor<question, M, Stored, NoCounts> visitor{scene, test_ray, counts, {}, {}};
  Trace<Real, Grid, VisitorFor<question, M, Stored, NoCounts>> trace(grid, ClippedRay<Real>{}, visitor);
  bool alive = false, more = true;
  for (;;) {
    const unsigned idle = __ballot_sync(all_lanes, !alive);
    if (more && __popc(idle) >= enough) {
      std::uint64_t number = std::uint64_t{blockIdx.x} * rays_a_block + threadIdx.x;
      more = false;
      if constexpr (refills) {
        unsigned long long first = 0;
        if (lane == 0) first = atomicAdd(next, static_cast<unsigned long long>(__popc(idle)));
        first = __shfl_sync(all_lanes, first, 0);
        more = first + static_cast<unsigned>(__popc(idle)) < count;
        number = first + static_cast<unsigned>(__popc(idle & ((1U << lane) - 1)));
      }
      if (!alive && number < count) {
        ScaledRay<Real> ray = scaled(rays[number]);
        if constexpr (question == Question::blocked) ray.ray.t_max = 1 / ray.scale;
        ClippedRay<Real> near{};
        alive = clip(ray.ray, cast<Real>(scene.clip), near);
        own = {ray.scale, near.skipped, near.ray.t_max, number};
        reset(visitor, near.ray.t_max);
        if (alive) {
          prepare(test_ray, near.ray.origin, near.ray.direction);
          trace.walk = Walk<Real, Grid>(grid, near);
          trace.next = empty_list;
        } else {
          hits[number] = found_by(visitor, own.t_max, own.skipped, own.scale, name);
        }
      }
      continue;
    }
    if (idle == all_lanes) return;
    if (alive) {
      if (!trace.testing()) trace.enter(grid);
#pragma unroll 1
      for (int test = 0; test < tests_a_turn && trace.testing(); ++test)
        trace.test(grid);
      if (!trace.testing()) {
        alive = trace.leave(grid);
        if (!alive) hits[own.number] = found_by(visitor, own.t_max, own.skipped, own.scale, name);
      }
    }
  }
}

// Launches the kernel so many times and waits; its code is on the device before the time starts, and before()
// puts what it needs onto the stream. The median's seconds.
template <class Before, class Kernel, class... Arguments>
double timed_launch(KernelSize& size, int warm_up, int repeat, const Before& before, Kernel* kernel,
                    dim3 blocks, dim3 threads, const Arguments&... arguments) {
  cudaFuncAttributes attributes;
  check(cudaFuncGetAttributes(&attributes, kernel));
  size = {attributes.numRegs, static_cast<std::int32_t>(attributes.localSizeBytes)};
  for (int i = 0; i < warm_up; ++i) {
    before();
    kernel<<<blocks, threads>>>(arguments...);
  }
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    before();
    const DeviceTimer timer;
    kernel<<<blocks, threads>>>(arguments...);
    check(cudaGetLastError());
    seconds.push_back(timer.seconds());
  }
  return median(std::move(seconds));
}

// How many blocks of so many threads run at once: `each` on a multiprocessor, or for 0 as many as fit.
template <class Kernel>
std::uint32_t resident_blocks(Kernel* kernel, int threads, int each) {
  int device = 0, multiprocessors = 0, fitting = 0;
  check(cudaGetDevice(&device));
  check(cudaDeviceGetAttribute(&multiprocessors, cudaDevAttrMultiProcessorCount, device));
  check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&fitting, kernel, threads, 0));
  return static_cast<std::uint32_t>(multiprocessors * std::max(each > 0 ? each : fitting, 1));
}

// Traces with rays of this arithmetic: a picture, a list of rays. Throw Error(device).
template <class TestRay, class Stored>
void render_on_device(const SceneView<Stored>& host_scene, const GridFile* host_grid,
                      const FrameRequest& request, Frame& frame) {
  DeviceArray<Vec3f> colors(frame.radiance.size());
  DeviceArray<EyeHit> hits(frame.hits.size());
  const DeviceArray<std::uint32_t> next_tile(1);
  const DeviceArray<Counts> total(&frame.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  const Uploaded<Stored> device(host_scene, host_grid);
  frame.seconds.upload = device.seconds;
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = device.grid.moved(view);
    const auto rays = eye_rays<typename M::Real>(request.camera, request.sampling, request.hither);
    const Tiles tiles = tiles_of(frame.columns, frame.rows);
    auto* const kernel = render_kernel<M, Stored, std::decay_t<decltype(grid)>, C>;
    frame.workers =
        request.schedule == Schedule::hardware
            ? tiles.count
            : std::min(tiles.count, resident_blocks(kernel, tile_side * tile_side, request.workers_each));
    const bool fetch = request.schedule == Schedule::persistent;
    const auto reset = [&] { check(cudaMemsetAsync(next_tile.data(), 0, sizeof(std::uint32_t))); };
    frame.seconds.trace = timed_launch(
        frame.kernel, request.warm_up, request.repeat, reset, kernel, dim3(frame.workers),
        dim3(tile_side, tile_side), device.scene.view, grid, rays, request.rules, tiles, request.schedule,
        fetch ? next_tile.data() : nullptr, colors.data(), hits.data(), total.data());
  });
  const Stopwatch watch;
  colors.download(frame.radiance.data());
  hits.download(frame.hits.data());
  total.download(&frame.counts);
  frame.seconds.download = watch.seconds();
}

template <class TestRay, class Stored>
void trace_on_device(const SceneView<Stored>& host_scene, const GridFile* host_grid,
                     const RaysRequest& request, RayHits& result) {
  using Real = typename TestRay::Real;
  std::vector<TypedRay<Real>> rays(request.rays.size());
  std::transform(request.rays.begin(), request.rays.end(), rays.begin(), typed<Real>);
  Stopwatch watch;
  const DeviceArray<TypedRay<Real>> device_rays(rays.data(), rays.size());
  DeviceArray<EyeHit> hits(rays.size());
  const DeviceArray<Counts> total(&result.counts, request.tracing.count || host_grid == nullptr ? 1 : 0);
  const DeviceArray<unsigned long long> next_ray(1);
  result.seconds.upload = watch.seconds();
  const Uploaded<Stored> device(host_scene, host_grid);
  result.seconds.upload += device.seconds;
  if (rays.empty()) return;
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = device.grid.moved(view);
    using Accelerator = std::decay_t<decltype(grid)>;
    with_question(request.question, [&]<Question question>(Asked<question>) {
      const auto timed = [&](const auto& before, auto* kernel, std::uint64_t blocks, auto* last) {
        result.seconds.trace =
            timed_launch(result.kernel, request.warm_up, request.repeat, before, kernel,
                         dim3(static_cast<unsigned>(blocks)), dim3(rays_a_block), device.scene.view, grid,
                         device_rays.data(), rays.size(), request.hit_name, hits.data(), last);
      };
      const std::uint64_t all_blocks = (rays.size() + rays_a_block - 1) / rays_a_block;
      if constexpr (std::is_same_v<C, NoCounts> && !std::is_same_v<Accelerator, NoGrid>) {
        if (request.loop == RayLoop::turns)
          return timed([] {}, turns_kernel<false, question, M, Stored, Accelerator>, all_blocks,
                       next_ray.data());
        if (request.loop == RayLoop::refill) {
          auto* const kernel = turns_kernel<true, question, M, Stored, Accelerator>;
          const std::uint64_t fitting = resident_blocks(kernel, rays_a_block, 0);
          const auto reset = [&] { check(cudaMemsetAsync(next_ray.data(), 0, sizeof(unsigned long long))); };
          return timed(reset, kernel, std::min(all_blocks, fitting), next_ray.data());
        }
      }
      timed([] {}, trace_kernel<question, M, Stored, Accelerator, C>, all_blocks, total.data());
    });
  });
  watch = Stopwatch();
  hits.download(result.hits.data());
  total.download(&result.counts);
  result.seconds.download = watch.seconds();
}

} // namespace masu
