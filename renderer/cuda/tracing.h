// Lists of rays on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Kernels of float32 and of double arithmetic are compiled in a source each (rays_*.cu), which instantiates
// queue_batch(): so they are compiled at the same time.
#pragma once

#include "renderer/cuda/device_method.h"
#include "renderer/cuda/hierarchy_rays.h"
#include "renderer/cuda/queue.h"
#include "renderer/cuda/warp_tracing.h"

namespace masu {

template <Query query, class M, class Stored, class Structure, class C>
__global__ void __launch_bounds__(rays_per_block, resident_threads_wanted<M> / rays_per_block)
    trace_kernel(const SceneView<Stored> scene, const Structure grid, const Ray<typename M::Real>* const rays,
                 const std::uint64_t count, const RayResults results, Counts* const total) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i >= count) return;
  C counts;
  write_hit<query>(results, i, trace_listed<query, M>(scene, grid, streamed(rays + i), counts));
  write_costs(results.costs, i, counts);
  add(total, counts);
}

template <class Real, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    attributes_kernel(const SceneView<Stored> scene, const Ray<Real>* const rays, const std::uint64_t count,
                      const RayResults found, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i < count) write_attributes(scene, streamed(rays + i), {found.t[i], found.primitive[i]}, results, i);
}

// Of hits in order, through any structure: one kernel for all such queries.
template <class M, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    hits_kernel(const SceneView<Stored> scene, const AnyStructure<typename M::Real> structure,
                const Ray<typename M::Real>* const rays, const RayFilters filters, const std::uint64_t count,
                const HitRules rules, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i >= count) return;
  write_hits<M>(scene, structure, streamed(rays + i), filters, rules, results, i);
}

// `double` traces occlusion and hierarchies by a thread per ray, `fast` everything: they aren't worth their
// kernels.
template <Query query, class TestRay, class Structure>
constexpr bool has_warp_loops = std::is_same_v<TestRay, WatertightRay<float>> ||
                                (std::is_same_v<TestRay, WatertightRay<double>> &&
                                 query == Query::nearest_hit && !is_hierarchy<Structure>);

// A list of rays, with room for those that culling chooses where that may be worth it.
template <class Real>
struct CullingMemory {
  DeviceArray<std::uint32_t> chosen;
  RayQueue<Real> queue;

  CullingMemory(const Ray<Real>* rays, std::uint32_t count, bool refills, const Queue& stream)
      : chosen(refills && count >= min_rays_culled ? count : 0, stream), queue{rays, count, chosen.data(),
                                                                               chosen.size() > 0} {}
};

template <class Real, class Stored>
void cull(const DeviceFilesOf<Stored>& files, Query query, const RayBatch<Real>& batch,
          const CullingMemory<Real>& culled, WarpProgress* progress) {
  if (!culled.queue.may_cull) return;
  auto* const kernel = cull_kernel<Real, Stored>;
  launch(kernel, files.kernels->of(kernel, threads_per_culling_block).blocks, threads_per_culling_block,
         batch.queue.stream, files.scene.view, batch.rays, culled.queue.count, query, batch.results,
         culled.chosen.data(), progress);
}

// Traces by warp or warp_refill (RayLoop).
template <Query query, class M, class Stored, class Structure>
KernelSize trace_by_warps(const DeviceFilesOf<Stored>& files, const Structure& grid, RayLoop loop,
                          const RayBatch<typename M::Real>& batch) {
  using Real = typename M::Real;
  const SceneView<Stored>& scene = files.scene.view;
  const auto count = static_cast<std::uint32_t>(batch.count);
  const cudaStream_t stream = batch.queue.stream;
  const bool refills = loop == RayLoop::warp_refill;
  auto* const trace = warp_kernel<false, query, OnDevice<M>, Stored, Structure>;
  auto* const finish = warp_kernel<true, query, OnDevice<M>, Stored, Structure>;
  const auto known = files.kernels->of(trace, rays_per_block),
             known_finish = files.kernels->of(finish, rays_per_block);
  const std::uint32_t blocks = std::min(blocks_of(rays_per_block, count), known.blocks),
                      finishing = std::max(blocks, known_finish.blocks);
  const StragglerQueueMemory<Real> left(blocks * (rays_per_block / lanes_per_warp), batch.queue);
  const CullingMemory<Real> culled(batch.rays, count, refills, batch.queue);
  const RayQueue<Real>& queue = culled.queue;
  batch.begin();
  cull(files, query, batch, culled, left.view().progress);
  const int fetching = refills ? some_fetch : all_fetch;
  launch(trace, blocks, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left.view());
  launch(finish, finishing, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left.view());
  return known.size;
}

// Traces through a hierarchy by thread_per_ray or warp_refill.
template <Query query, class M, class Stored, class Hierarchy>
KernelSize trace_by_hierarchy(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy, RayLoop loop,
                              const RayBatch<typename M::Real>& batch) {
  auto* const trace = packet_kernel<query, OnDevice<M>, Stored, Hierarchy>;
  auto* const refill = refill_kernel<query, OnDevice<M>, Stored, Hierarchy>;
  const bool refills = loop == RayLoop::warp_refill;
  const auto known =
      refills ? files.kernels->of(refill, rays_per_block) : files.kernels->of(trace, rays_per_block);
  const std::uint64_t launches = (batch.count + max_rays_by_warps - 1) / max_rays_by_warps;
  const DeviceArray<std::uint32_t> next_rays(refills ? launches : 0, batch.queue);
  next_rays.clear();
  batch.begin();
  RayResults results = batch.results;
  for (std::uint64_t i = 0; i < launches; ++i) {
    const std::uint64_t first = i * max_rays_by_warps;
    const auto count = static_cast<std::uint32_t>(std::min(batch.count - first, max_rays_by_warps));
    const std::uint32_t blocks = blocks_of(rays_per_block, count);
    const auto launch_with = [&](auto* kernel, std::uint32_t of, const auto&... more) {
      launch(kernel, of, rays_per_block, batch.queue.stream, files.scene.view, hierarchy, batch.rays + first,
             count, results, more...);
    };
    if (refills)
      launch_with(refill, std::min(blocks, known.blocks), next_rays.data() + i);
    else
      launch_with(trace, blocks);
    for_each_array(results, [&](auto*& array) {
      if (array != nullptr) array += count;
    });
  }
  return known.size;
}

// Puts a query on its stream. Throws Error(device).
template <class TestRay, class Stored>
KernelSize queue_batch(const DeviceFilesOf<Stored>& files, const SceneView<Stored>& host_scene,
                       const StructureFile* host_grid, const RaysRequest& request,
                       const RayBatch<typename TestRay::Real>& batch) {
  using Real = typename TestRay::Real;
  KernelSize size{};
  const auto& scene = files.scene.view;
  const bool by_warps = request.loop != RayLoop::thread_per_ray && batch.count <= max_rays_by_warps;
  with_method<TestRay>(host_scene, host_grid, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
    const auto grid = files.moved(view);
    using Accelerator = std::decay_t<decltype(grid)>;
    with_query(request.query, [&]<Query query>(QueryTag<query>) {
      // Lists go through uniform grids for comparison: for all kinds, and where a thread traces each ray by
      // the kernel for all structures.
      constexpr bool is_uniform = std::is_same_v<Accelerator, GridView<Real>>;
      using Used = std::conditional_t<is_uniform, Method<TestRay, with_all_kinds>, M>;
      constexpr bool has_loops = std::is_same_v<C, NoCounts> && has_warp_loops<query, TestRay, Accelerator>;
      if constexpr (has_loops) {
        if constexpr (is_any_structure<Accelerator>) {
          if (by_warps && grid.form == StructureForm::merged && grid.stop == StopRule::proven) {
            size = trace_by_warps<query, Used>(files, grid.merged, request.loop, batch);
            return;
          }
        } else if constexpr (!is_hierarchy<Accelerator>) {
          if (by_warps) {
            size = trace_by_warps<query, Used>(files, grid, request.loop, batch);
            return;
          }
        } else {
          size = trace_by_hierarchy<query, Used>(files, grid, request.loop, batch); // `warp` is of grids
          return;
        }
      }
      if constexpr (!has_loops || !is_hierarchy<Accelerator>) {
        const auto trace_through = [&](const auto& structure) {
          auto* const kernel =
              trace_kernel<query, OnDevice<Used>, Stored, std::decay_t<decltype(structure)>, C>;
          size = files.kernels->of(kernel, rays_per_block).size;
          batch.begin();
          launch(kernel, blocks_of(rays_per_block, batch.count), rays_per_block, batch.queue.stream, scene,
                 structure, batch.rays, batch.count, batch.results, batch.counts);
        };
        if constexpr (is_uniform)
          trace_through(files.grid.moved(any_structure<Real>(host_grid)));
        else
          trace_through(grid);
      }
    });
  });
  return size;
}

template <class TestRay, class Stored>
KernelSize queue_hits(const DeviceFilesOf<Stored>& files, const StructureFile* host_grid,
                      const HitRules& rules, const RayFilters& filters,
                      const RayBatch<typename TestRay::Real>& batch) {
  using Real = typename TestRay::Real;
  auto* const kernel = hits_kernel<OnDevice<Method<TestRay, with_all_kinds>>, Stored>;
  batch.begin();
  launch(kernel, blocks_of(rays_per_block, batch.count), rays_per_block, batch.queue.stream, files.scene.view,
         files.grid.moved(any_structure<Real>(host_grid)), batch.rays, filters, batch.count, rules,
         batch.results);
  return files.kernels->of(kernel, rays_per_block).size;
}

template <class Real, class Stored>
void queue_attributes(const DeviceFilesOf<Stored>& files, const RayBatch<Real>& batch,
                      const RayResults& results) {
  launch(attributes_kernel<Real, Stored>, blocks_of(rays_per_block, batch.count), rays_per_block,
         batch.queue.stream, files.scene.view, batch.rays, batch.count, batch.results, results);
}

} // namespace masu
