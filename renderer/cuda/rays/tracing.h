// Lists of rays on a CUDA device: the kernels, and how they are launched. CUDA sources only.
//
// Kernels of float32 and of double arithmetic are compiled in a source each (rays_*.cu), which instantiates
// launch_list(): so they are compiled at the same time.
#pragma once

#include "renderer/cuda/ray_batch.h"
#include "renderer/cuda/rays/hierarchy_rays.h"
#include "renderer/cuda/rays/warp_tracing.h"

#include <vector>

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

template <class Real, class Stored, class Structure>
__global__ void __launch_bounds__(rays_per_block)
    names_kernel(const SceneView<Stored> scene, const __grid_constant__ Structure structure,
                 const Ray<Real>* const rays, const std::uint64_t count, const RayResults found,
                 const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i < count)
    write_named(scene, seen_by(structure, i), streamed(rays + i), Hit<float>{found.t[i], found.primitive[i]},
                results, i);
}

// Of hits in order, through any structure: one kernel for all such queries.
template <class M, class Stored, class Structure>
__global__ void __launch_bounds__(rays_per_block)
    hits_kernel(const SceneView<Stored> scene, const __grid_constant__ Structure structure,
                const Ray<typename M::Real>* const rays, const RayFilters filters, const std::uint64_t count,
                const HitRules rules, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i >= count) return;
  write_hits<M>(scene, seen_by(structure, i), streamed(rays + i), filters, rules, results, i);
}

// `double` traces occlusion and hierarchies by a thread per ray, `fast` everything: they aren't worth their
// kernels.
template <class C, Query query, class TestRay, class Structure>
constexpr bool has_loops = !C::is_counted && !std::is_same_v<TestRay, TextbookRay> &&
                           (std::is_same_v<typename TestRay::Real, float> ||
                            (query == Query::nearest_hit && !is_hierarchy<Structure>));

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
  const DeviceArray<WarpProgress> progress(1, batch.memory);
  progress.clear();
  const DeviceArray<Straggler<Real>> stragglers(std::size_t{blocks} * rays_per_block, batch.memory);
  const StragglerQueue<Real> left{progress.data(), stragglers.data()};
  const DeviceArray<std::uint32_t> chosen(refills && count >= min_rays_culled ? count : 0, batch.memory);
  const RayQueue<Real> queue{batch.rays, count, chosen.data()};
  batch.begin();
  if (auto* const cull = cull_kernel<Real, Stored>; chosen.size() > 0)
    launch(cull, files.kernels->of(cull, threads_per_culling_block).blocks, threads_per_culling_block, stream,
           scene, batch.rays, count, query, batch.results, chosen.data(), left.progress);
  const int fetching = refills ? some_fetch : all_fetch;
  launch(trace, blocks, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left);
  launch(finish, finishing, rays_per_block, stream, scene, grid, queue, fetching, batch.results, left);
  return known.size;
}

// Parts of a list that warps can number.
template <class Real>
std::vector<RayBatch<Real>> parts_of(const RayBatch<Real>& batch) {
  std::vector<RayBatch<Real>> parts;
  for (std::uint64_t first = 0; first < batch.count; first += max_rays_by_warps) {
    RayBatch<Real>& part = parts.emplace_back(batch);
    part.rays += first;
    part.count = std::min(batch.count - first, max_rays_by_warps);
    for_each_array(part.results, [&](auto*& array) {
      if (array != nullptr) array += first;
    });
  }
  return parts;
}

// Through a hierarchy by a thread per ray, by fetching, or by what the device chooses: then both are launched
// (loop_choice.h). Where `fetches_alone`, only fetching is compiled, and asked for.
template <Query query, class M, bool fetches_alone = false, class Stored, class Hierarchy>
KernelSize trace_by_hierarchy(const DeviceFilesOf<Stored>& files, const Hierarchy& hierarchy, RayLoop loop,
                              const RayBatch<typename M::Real>& batch) {
  using Real = typename M::Real;
  const SceneView<Stored>& scene = files.scene.view;
  const cudaStream_t stream = batch.memory.stream;
  if (loop == RayLoop::automatic && batch.count < min_rays_looked_at)
    loop = query == Query::nearest_hit && batch.count >= min_rays_fetched ? RayLoop::warp_refill
                                                                          : RayLoop::thread_per_ray;
  const bool chooses = loop == RayLoop::automatic, fetches = chooses || loop == RayLoop::warp_refill;
  const std::vector<RayBatch<Real>> parts = parts_of(batch);
  const DeviceArray<RayLoop> chosen(chooses ? 1 : 0, batch.memory);
  const DeviceArray<std::uint32_t> fetched(fetches ? parts.size() : 0, batch.memory); // rays of each part
  if (!chooses) fetched.clear();
  batch.begin();
  KernelSize size{};
  if constexpr (!fetches_alone) {
    auto* const kernel = packet_kernel<query, OnDevice<M>, Stored, Hierarchy>;
    if (chooses)
      launch(choose_loop_kernel<query, Real, Stored>, 1, warps_looked_at * lanes_per_warp, stream, scene,
             batch.rays, batch.count, chosen.data(), fetched.data(),
             static_cast<std::uint32_t>(fetched.size()));
    if (chooses || !fetches) {
      size = files.kernels->of(kernel, rays_per_block).size;
      for (const RayBatch<Real>& part : parts)
        launch(kernel, blocks_of(rays_per_block, part.count), rays_per_block, stream, scene,
               from_ray(hierarchy, part.rays - batch.rays), part.rays, static_cast<std::uint32_t>(part.count),
               part.results, chosen.data());
    }
  }
  if (!fetches) return size;
  auto* const kernel = refill_kernel<query, OnDevice<M>, Stored, Hierarchy>;
  const auto known = files.kernels->of(kernel, rays_per_block);
  for (std::size_t i = 0; i < parts.size(); ++i)
    launch(kernel, std::min(blocks_of(rays_per_block, parts[i].count), known.blocks), rays_per_block, stream,
           scene, from_ray(hierarchy, parts[i].rays - batch.rays), parts[i].rays,
           static_cast<std::uint32_t>(parts[i].count), parts[i].results, fetched.data() + i, chosen.data());
  return known.size;
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
  constexpr bool loops = has_loops<C, query, typename M::TestRay, Structure>;
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

// Hits in order (hit_list.h).
template <class TestRay, class Stored, class Structure>
KernelSize launch_hits(const DeviceFilesOf<Stored>& files, const Structure& structure, const HitRules& rules,
                       const RayFilters& filters, const RayBatch<typename TestRay::Real>& batch) {
  auto* const kernel = hits_kernel<OnDevice<Method<TestRay, with_all_kinds>>, Stored, Structure>;
  batch.begin();
  launch(kernel, blocks_of(rays_per_block, batch.count), rays_per_block, batch.memory.stream,
         files.scene.view, structure, batch.rays, filters, batch.count, rules, batch.results);
  return files.kernels->of(kernel, rays_per_block).size;
}

// Rays in device memory as they are traced, aligned for the kernels' loads: where they lie, or copied.
template <class Real, class Stored>
const Ray<Real>* converted(const RayList& list, const Box<Stored>& box, const StreamMemory& memory,
                           DeviceArray<Ray<Real>>& copy) {
  const void* const rays = list.rays;
  const RayFormat format = list.format;
  const bool is_own = format.is_float64 == (sizeof(Real) == sizeof(double)) && format.numbers == 8 &&
                      format.origin == Vec3d{0, 0, 0};
  if (is_own && reinterpret_cast<std::uintptr_t>(rays) % alignof(Ray<Real>) == 0)
    return static_cast<const Ray<Real>*>(rays);
  copy = DeviceArray<Ray<Real>>(list.count, memory);
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

template <class TestRay, class Stored>
KernelSize launch_list(const DeviceFiles& device_files, const RayList& list, const RayResults& results,
                       const RaysRequest& request, Counts* counts, cudaStream_t stream, cudaEvent_t begun) {
  using Real = typename TestRay::Real;
  const DeviceFilesOf<Stored>& files = device_files.of<Stored>();
  const StreamMemory memory{stream, files.memory.pool};
  const SceneView<Stored>& scene = files.scene.view;
  const bool is_placed = files.placements != nullptr, in_order = needs_hits_in_order(list, results, request),
             is_named = request.query == Query::nearest_hit && !in_order &&
                        (results.has_attributes() || (is_placed && results.primitive != nullptr));
  DeviceArray<Ray<Real>> copy;
  RayBatch<Real> batch{converted(list, scene.clip, memory, copy), list.count, results, counts, memory, begun};
  const auto room_for = [&]<class T>(T*& found) { // hits that names and attributes are found of
    DeviceArray<T> own(is_named && found == nullptr ? list.count : 0, memory);
    if (own.size() > 0) found = own.data();
    return own;
  };
  const DeviceArray<float> t = room_for(batch.results.t);
  const DeviceArray<std::uint32_t> primitive = room_for(batch.results.primitive);
  KernelSize size{};
  if constexpr (!std::is_same_v<TestRay, TextbookRay>) {
    if (is_placed) size = launch_placed<TestRay>(files, list, request, batch, results);
    if (in_order && !is_placed)
      size = launch_hits<TestRay>(files, files.on_device(any_structure<Real>(files.structure.records)),
                                  hit_rules(request), list.filters, batch);
  }
  if (!in_order && !is_placed)
    size = with_method<TestRay, Stored>(
        files.structure.records, request.tracing, [&]<class M, class C>(const auto& view, M, C) {
          const auto structure = files.on_device(view);
          return request.query == Query::occlusion
                     ? trace_list<Query::occlusion, M, C>(files, structure, request.loop, batch)
                     : trace_list<Query::nearest_hit, M, C>(files, structure, request.loop, batch);
        });
  if (is_named && !is_placed)
    launch(names_kernel<Real, Stored, NoStructure>, blocks_of(rays_per_block, batch.count), rays_per_block,
           memory.stream, scene, NoStructure{}, batch.rays, batch.count, batch.results, results);
  if (request.query != Query::occlusion)
    launch_to_list<Real>(list, scene.clip, results, hit_rules(request).row(), memory);
  return size;
}

} // namespace masu
