// Placed meshes on a CUDA device, and rays through them. CUDA sources only.
//
// Rays are traced by hierarchies' loop that fetches them for idle lanes (hierarchy_rays.h), or, where hits
// are found in their order, by a thread each. A pass over the hits names them.
#pragma once

#include "libgrid/placed/place_passes.h"
#include "libgrid/placed/placed_packet.h"
#include "libscene/passes/cuda_executor.h"
#include "renderer/cuda/rays/tracing.h"
#include "renderer/rays/placed_rays.h"

namespace masu {

template <class Stored>
struct PlacedOnDevice {
  SharedArrays parts_memory; // of what doesn't move
  std::shared_ptr<const CudaExecutor> executor;
  PlacedArrays<CudaExecutor, Stored> arrays;
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
  if (list.filters.worlds != nullptr) list.filters.worlds += first;
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
  if (list.filters.worlds != nullptr) seen.world = list.filters.worlds[number];
  own.walk.begin(seen, near, stack);
}

// Code for triangles alone is compiled for float32.
template <class TestRay, class Stored>
KernelSize launch_placed(const DeviceFilesOf<Stored>& files, const RayList& list, const RaysRequest& request,
                         const RayBatch<typename TestRay::Real>& batch, const RayResults& results) {
  using Real = typename TestRay::Real;
  using General = Method<TestRay, with_all_kinds>;
  const SceneView<Stored>& scene = files.scene.view;
  const PlacedList<Stored> placed{files.placements->arrays.view(), list.filters};
  if (needs_hits_in_order(list, results, request) || placed.placed.is_brute_force)
    return launch_hits<TestRay>(files, placed, hit_rules(request), list.filters, batch);
  const bool triangles_alone = scene.sphere_count + scene.cone_count == 0;
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
    launch(names_kernel<Real, Stored, PlacedList<Stored>>, blocks_of(rays_per_block, batch.count),
           rays_per_block, batch.memory.stream, scene, placed, batch.rays, batch.count, batch.results,
           results);
  return size;
}

} // namespace masu
