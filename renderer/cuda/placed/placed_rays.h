// Rays through placed meshes on a CUDA device. CUDA sources only.
//
// Rays are traced by hierarchies' loop that fetches them for idle lanes (hierarchy_rays.h), or, where hits
// are found in their order, by a thread each. A pass over the hits names them.
#pragma once

#include "libgrid/placed/placed_packet.h"
#include "renderer/cuda/placed/placed.h"
#include "renderer/cuda/rays/tracing.h"
#include "renderer/rays/placed_rays.h"

namespace masu {

// Placed meshes, as the rays of a list see them.
template <class Stored>
struct PlacedList {
  PlacedView<Stored> placed;
  const std::uint32_t* worlds; // of each ray, or null
};

// Their walk needs more registers.
template <class Stored>
struct WalksThrough<PlacedList<Stored>> {
  template <class Real>
  using Walk = PlacedWalk<Real>;
  template <class M>
  static constexpr int packet_threads_wanted = resident_threads_wanted<M> / 8 * 7;
  // By pairs, too, the code outgrows its cache.
  static constexpr int last_of_packet = max_rays_by_fours, last_fetched = max_rays_by_fours;
};
// Of any world: worlds are where a walk begins.
template <class Stored>
__device__ inline PlacedRay<Stored> seen_by_rays(const PlacedList<Stored>& list) {
  return {list.placed};
}
template <class Stored>
PlacedList<Stored> from_ray(PlacedList<Stored> list, std::uint64_t first) {
  if (list.worlds != nullptr) list.worlds += first;
  return list;
}
template <class Stored, class TestRay>
__device__ inline void begin_ray(const PlacedList<Stored>& list,
                                 const ClippedRay<typename TestRay::Real>& near, std::uint32_t number,
                                 WalkingRay<TestRay, PlacedWalk<typename TestRay::Real>>& own,
                                 HierarchyStack& stack) {
  own.nearest = {near.ray.t_max, 0};
  prepare(own.test_ray, near.ray.origin, near.ray.direction);
  PlacedRay<Stored> seen{list.placed};
  if (list.worlds != nullptr) seen.world = list.worlds[number];
  own.walk.begin(seen, near, stack);
}

template <class M, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    placed_hits_kernel(const SceneView<Stored> scene, const __grid_constant__ PlacedView<Stored> placed,
                       const Ray<typename M::Real>* const rays, const RayFilters filters,
                       const PlacedFilters placed_filters, const std::uint64_t count, const HitRules rules,
                       const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i >= count) return;
  write_hits<M>(scene, placed_ray(placed, filters, placed_filters, i), streamed(rays + i), filters, rules,
                results, i);
}

template <class Real, class Stored>
__global__ void __launch_bounds__(rays_per_block)
    placed_names_kernel(const SceneView<Stored> scene, const __grid_constant__ PlacedView<Stored> placed,
                        const Ray<Real>* const rays, const std::uint64_t count, const RayResults found,
                        const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * rays_per_block + threadIdx.x;
  if (i < count)
    write_named(scene, PlacedRay<Stored>{placed}, streamed(rays + i),
                Hit<float>{found.t[i], found.primitive[i]}, results, i);
}

// Code for triangles alone is compiled for float32.
template <class TestRay, class Stored>
KernelSize launch_placed(const DeviceFilesOf<Stored>& files, const RayList& list, const RaysRequest& request,
                         const RayBatch<typename TestRay::Real>& batch, const RayResults& results) {
  using Real = typename TestRay::Real;
  using General = Method<TestRay, with_all_kinds>;
  const SceneView<Stored>& scene = files.scene.view;
  const std::uint32_t blocks = blocks_of(rays_per_block, batch.count);
  const cudaStream_t stream = batch.memory.stream;
  if (needs_hits_in_order(list, results, request) || files.placements->arrays.parts.is_brute_force) {
    auto* const kernel = placed_hits_kernel<OnDevice<General>, Stored>;
    batch.begin();
    launch(kernel, blocks, rays_per_block, stream, scene, files.placements->arrays.view(), batch.rays,
           list.filters, list.placed_filters, batch.count, hit_rules(request), results);
    return files.kernels->of(kernel, rays_per_block).size;
  }
  const bool triangles_alone = scene.sphere_count + scene.cone_count == 0;
  const PlacedList<Stored> placed{files.placements->arrays.view(), list.placed_filters.worlds};
  KernelSize size{};
  with_query(request.query, [&]<Query query>(QueryTag<query>) {
    if constexpr (std::is_same_v<TestRay, WatertightRay<float>>)
      if (triangles_alone) {
        size = trace_by_hierarchy<query, Method<TestRay, with_triangles>>(files, placed, request.loop, batch);
        return;
      }
    size = trace_by_hierarchy<query, General, true>(files, placed, RayLoop::warp_refill, batch);
  });
  if (request.query == Query::nearest_hit && (results.primitive != nullptr || results.has_attributes()))
    launch(placed_names_kernel<Real, Stored>, blocks, rays_per_block, stream, scene,
           files.placements->arrays.view(), batch.rays, batch.count, batch.results, results);
  return size;
}

} // namespace masu
