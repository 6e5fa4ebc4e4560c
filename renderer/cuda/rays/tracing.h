// Lists of rays on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Kernels of float32 and of double arithmetic are compiled in a source each (rays_*.cu), which instantiates
// launch_batch(): so they are compiled at the same time.
#pragma once

#include "renderer/cuda/device_method.h"
#include "renderer/cuda/ray_batch.h"
#include "renderer/cuda/rays/hierarchy_rays.h"
#include "renderer/cuda/rays/warp_tracing.h"

namespace masu {

template <Query query, class M, class Stored, class Structure, class C>
__global__ void __launch_bounds__(rays_per_block, resident_threads_wanted<M> / rays_per_block)
    trace_kernel(const SceneView<Stored> scene, const Structure structure,
                 const Ray<typename M::Real>* const rays, const std::uint64_t count, const RayResults results,
                 Counts* const total) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i >= count) return;
  C counts;
  write_hit<query>(results, i, trace_listed<query, M>(scene, structure, streamed(rays + i), counts));
  write_costs(results.costs, i, counts);
  add(total, counts);
}

template <class Real, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    attributes_kernel(const SceneView<Stored> scene, const Ray<Real>* const rays, const std::uint64_t count,
                      const RayResults found, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i < count)
    write_attributes(scene, NoStructure{}, streamed(rays + i), {found.t[i], found.primitive[i]}, results, i);
}

// Of hits in order, through any structure: one kernel for all such queries.
template <class M, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    hits_kernel(const SceneView<Stored> scene, const AnyOnDevice<typename M::Real, Stored> structure,
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

  CullingMemory(const Ray<Real>* rays, std::uint32_t count, bool refills, const StreamMemory& memory)
      : chosen(refills && count >= min_rays_culled ? count : 0, memory), queue{rays, count, chosen.data(),
                                                                               chosen.size() > 0} {}
};

template <class Real, class Stored>
void cull(const DeviceFilesOf<Stored>& files, Query query, const RayBatch<Real>& batch,
          const CullingMemory<Real>& culled, WarpProgress* progress) {
  if (!culled.queue.may_cull) return;
  auto* const kernel = cull_kernel<Real, Stored>;
  launch(kernel, files.kernels->of(kernel, threads_per_culling_block).blocks, threads_per_culling_block,
         batch.memory.stream, files.scene.view, batch.rays, culled.queue.count, query, batch.results,
         culled.chosen.data(), progress);
}

// Traces by warp or warp_refill (RayLoop).
template <Query query, class M, class Stored, class Structure>
KernelSize trace_by_warps(const DeviceFilesOf<Stored>& files, const Structure& grid, RayLoop loop,
                          const RayBatch<typename M::Real>& batch) {
  using Real = typename M::Real;
  const SceneView<Stored>& scene = files.scene.view;
  const auto count = static_cast<std::uint32_t>(batch.count);
  const cudaStream_t stream = batch.memory.stream;
  const bool refills = loop != RayLoop::warp;
  auto* const trace = warp_kernel<false, query, OnDevice<M>, Stored, Structure>;
  auto* const finish = warp_kernel<true, query, OnDevice<M>, Stored, Structure>;
  const auto known = files.kernels->of(trace, rays_per_block),
             known_finish = files.kernels->of(finish, rays_per_block);
  const std::uint32_t blocks = std::min(blocks_of(rays_per_block, count), known.blocks),
                      finishing = std::max(blocks, known_finish.blocks);
  const StragglerQueueMemory<Real> left(blocks * (rays_per_block / lanes_per_warp), batch.memory);
  const CullingMemory<Real> culled(batch.rays, count, refills, batch.memory);
  const RayQueue<Real>& queue = culled.queue;
  batch.begin();
  cull(files, query, batch, culled, left.view().progress);
  const int fetching = refills ? some_fetch : all_fetch;
  launch(trace, blocks, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left.view());
  launch(finish, finishing, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left.view());
  return known.size;
}

// act(batch, first, count) for parts of a list that warps can number, from ray `first` on.
template <class Real, class Act>
void for_each_part(const RayBatch<Real>& all, const Act& act) {
  RayBatch<Real> part = all;
  for (std::uint64_t first = 0; first < all.count; first += max_rays_by_warps) {
    const auto count = static_cast<std::uint32_t>(std::min(all.count - first, max_rays_by_warps));
    act(std::as_const(part), first, count);
    part.rays += count;
    for_each_array(part.results, [&](auto*& array) {
      if (array != nullptr) array += count;
    });
  }
}

// Through a hierarchy, by a thread per ray; if that is the loop on the device (is_chosen()).
template <Query query, class M, class Stored, class Hierarchy>
KernelSize trace_by_packets(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy,
                            const RayBatch<typename M::Real>& batch, const RayLoop* chosen) {
  auto* const kernel = packet_kernel<query, OnDevice<M>, Stored, Hierarchy>;
  for_each_part(batch, [&](const auto& part, std::uint64_t first, std::uint32_t count) {
    launch(kernel, blocks_of(rays_per_block, count), rays_per_block, batch.memory.stream, files.scene.view,
           from_ray(hierarchy, first), part.rays, count, part.results, chosen);
  });
  return files.kernels->of(kernel, rays_per_block).size;
}

// Likewise by fetching. `fetched`: of each part so many rays, 0 at first.
template <Query query, class M, class Stored, class Hierarchy>
KernelSize trace_by_refill(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy,
                           const RayBatch<typename M::Real>& batch, const RayLoop* chosen,
                           std::uint32_t* fetched) {
  auto* const kernel = refill_kernel<query, OnDevice<M>, Stored, Hierarchy>;
  const auto known = files.kernels->of(kernel, rays_per_block);
  for_each_part(batch, [&](const auto& part, std::uint64_t first, std::uint32_t count) {
    launch(kernel, std::min(blocks_of(rays_per_block, count), known.blocks), rays_per_block,
           batch.memory.stream, files.scene.view, from_ray(hierarchy, first), part.rays, count, part.results,
           fetched++, chosen);
  });
  return known.size;
}
inline DeviceArray<std::uint32_t> fetched_of_parts(std::uint64_t rays, const StreamMemory& memory) {
  return DeviceArray<std::uint32_t>((rays + max_rays_by_warps - 1) / max_rays_by_warps, memory);
}
template <Query query, class M, class Stored, class Hierarchy>
KernelSize trace_by_refill(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy,
                           const RayBatch<typename M::Real>& batch) {
  const DeviceArray<std::uint32_t> fetched = fetched_of_parts(batch.count, batch.memory);
  fetched.clear();
  batch.begin();
  return trace_by_refill<query, M>(files, hierarchy, batch, nullptr, fetched.data());
}

template <Query query, class M, class Stored, class Hierarchy>
KernelSize trace_by_hierarchy(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy, RayLoop loop,
                              const RayBatch<typename M::Real>& batch) {
  using Real = typename M::Real;
  if (loop == RayLoop::automatic && batch.count < min_rays_looked_at) loop = loop_of_few(query, batch.count);
  if (loop == RayLoop::warp_refill) return trace_by_refill<query, M>(files, hierarchy, batch);
  if (loop != RayLoop::automatic) {
    batch.begin();
    return trace_by_packets<query, M>(files, hierarchy, batch, nullptr);
  }
  const DeviceArray<RayLoop> chosen(1, batch.memory);
  const DeviceArray<std::uint32_t> fetched = fetched_of_parts(batch.count, batch.memory);
  batch.begin();
  launch(choose_loop_kernel<query, Real, Stored>, 1, warps_looked_at * lanes_per_warp, batch.memory.stream,
         files.scene.view, batch.rays, batch.count, chosen.data(), fetched.data(),
         static_cast<std::uint32_t>(fetched.size()));
  trace_by_packets<query, M>(files, hierarchy, batch, chosen.data());
  return trace_by_refill<query, M>(files, hierarchy, batch, chosen.data(), fetched.data());
}

// Traces with a thread per ray.
template <Query query, class M, class C, class Stored, class Structure>
KernelSize trace_by_threads(const DeviceFilesOf<Stored>& files, const Structure& structure,
                            const RayBatch<typename M::Real>& batch) {
  auto* const kernel = trace_kernel<query, OnDevice<M>, Stored, Structure, C>;
  const KernelSize size = files.kernels->of(kernel, rays_per_block).size;
  batch.begin();
  launch(kernel, blocks_of(rays_per_block, batch.count), rays_per_block, batch.memory.stream,
         files.scene.view, structure, batch.rays, batch.count, batch.results, batch.counts);
  return size;
}

template <class C, Query query, class M, class Structure>
constexpr bool has_loops =
    std::is_same_v<C, NoCounts>&& has_warp_loops<query, typename M::TestRay, Structure>;

// How a list goes through each structure, by the loop that is asked for where that has kernels; automatic is
// chosen on the device through a hierarchy, elsewhere warp_refill:
//
//                    thread_per_ray       warp             warp_refill
//   merged grid      trace_by_threads     trace_by_warps   trace_by_warps
//   hierarchy        trace_by_hierarchy   as the former    trace_by_hierarchy
//   uniform grid     as any structure     trace_by_warps   trace_by_warps: for comparison, by all kinds' code
//   any structure    trace_by_threads     trace_by_warps   trace_by_warps: of merged grids alone
template <Query query, class M, class C, class Stored, class Structure>
KernelSize trace_list(const DeviceFilesOf<Stored>& files, const Structure& structure, RayLoop loop,
                      const RayBatch<typename M::Real>& batch) {
  using Real = typename M::Real;
  constexpr bool loops = has_loops<C, query, M, Structure>;
  const bool by_warps = loop != RayLoop::thread_per_ray && batch.count <= max_rays_by_warps;
  if constexpr (loops && is_hierarchy<Structure>) {
    return trace_by_hierarchy<query, M>(files, structure, loop, batch);
  } else if constexpr (std::is_same_v<Structure, GridView<Real>>) {
    using General = Method<typename M::TestRay, with_all_kinds>;
    if constexpr (loops)
      if (by_warps) return trace_by_warps<query, General>(files, structure, loop, batch);
    return trace_by_threads<query, General, C>(
        files, files.on_device(any_structure<Real>(files.structure.records)), batch);
  } else {
    if constexpr (loops && is_any_structure<Structure>) {
      if (by_warps && structure.form == StructureForm::merged && structure.stop == StopRule::proven)
        return trace_by_warps<query, M>(files, structure.merged, loop, batch);
    } else if constexpr (loops) {
      if (by_warps) return trace_by_warps<query, M>(files, structure, loop, batch);
    }
    return trace_by_threads<query, M, C>(files, structure, batch);
  }
}

template <class TestRay, class Stored>
KernelSize launch_batch(const DeviceFilesOf<Stored>& files, const RaysRequest& request,
                        const RayBatch<typename TestRay::Real>& batch) {
  KernelSize size{};
  with_method<TestRay, Stored>(
      files.structure.records, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
        with_query(request.query, [&]<Query query>(QueryTag<query>) {
          size = trace_list<query, M, C>(files, files.on_device(view), request.loop, batch);
        });
      });
  return size;
}

template <class TestRay, class Stored>
KernelSize launch_hits(const DeviceFilesOf<Stored>& files, const HitRules& rules, const RayFilters& filters,
                       const RayBatch<typename TestRay::Real>& batch) {
  using Real = typename TestRay::Real;
  auto* const kernel = hits_kernel<OnDevice<Method<TestRay, with_all_kinds>>, Stored>;
  batch.begin();
  launch(kernel, blocks_of(rays_per_block, batch.count), rays_per_block, batch.memory.stream,
         files.scene.view, files.on_device(any_structure<Real>(files.structure.records)), batch.rays, filters,
         batch.count, rules, batch.results);
  return files.kernels->of(kernel, rays_per_block).size;
}

template <class Real, class Stored>
void launch_attributes(const DeviceFilesOf<Stored>& files, const RayBatch<Real>& batch,
                       const RayResults& results) {
  launch(attributes_kernel<Real, Stored>, blocks_of(rays_per_block, batch.count), rays_per_block,
         batch.memory.stream, files.scene.view, batch.rays, batch.count, batch.results, results);
}

} // namespace masu
