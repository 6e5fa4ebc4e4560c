#include "renderer/cuda/placed/placed_rays.h"
#include "renderer/rays/closest_points.h"

namespace masu {
namespace {

constexpr unsigned places_per_block = 128;

template <class Stored, class Structure>
__global__ void __launch_bounds__(places_per_block)
    closest_kernel(const SceneView<Stored> scene, const __grid_constant__ Structure structure,
                   const void* const places, const RayFormat format, const RayFilters filters,
                   const std::uint64_t count, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * places_per_block + threadIdx.x;
  if (i < count) write_closest(scene, seen_by(structure, i), places, format, filters, results, i);
}

} // namespace

KernelSize launch_closest(const DeviceFiles& files, const RayList& places, const RayResults& results,
                          const RaysRequest&, Counts*, cudaStream_t stream, cudaEvent_t begun) {
  return files.with_store([&]<class Stored>(const DeviceFilesOf<Stored>& stored) {
    const auto start = [&]<class Structure>(const Structure& structure) {
      auto* const kernel = closest_kernel<Stored, Structure>;
      const KernelSize size = stored.kernels->of(kernel, places_per_block).size;
      if (begun != nullptr) check(cudaEventRecord(begun, stream));
      launch(kernel, blocks_of(places_per_block, places.count), places_per_block, stream, stored.scene.view,
             structure, places.rays, places.format, places.filters, places.count, results);
      return size;
    };
    if (stored.placements != nullptr) {
      check_closest(stored.placements->arrays.bounds);
      return start(PlacedList<Stored>{stored.placements->arrays.view(), places.filters});
    }
    if (!stored.is_hierarchy()) return start(NoStructure{});
    return start(stored.on_device(hierarchy_view_of<Stored>(*stored.structure.records)));
  });
}

} // namespace masu
