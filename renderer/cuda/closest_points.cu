#include "renderer/cuda/placed/placed.h"
#include "renderer/cuda/ray_batch.h"
#include "renderer/rays/closest_points.h"
#include "renderer/rays/placed_rays.h"

namespace masu {
namespace {

constexpr unsigned places_per_block = 128;

template <class Stored>
__global__ void __launch_bounds__(places_per_block)
    closest_kernel(const SceneView<Stored> scene, const AnyOnDevice<Stored, Stored> structure,
                   const void* const places, const RayFormat format, const RayFilters filters,
                   const std::uint64_t count, const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * places_per_block + threadIdx.x;
  if (i >= count) return;
  if (structure.form == StructureForm::hierarchy)
    write_closest(scene, structure.hierarchy, places, format, filters, results, i);
  else
    write_closest(scene, NoStructure{}, places, format, filters, results, i);
}

template <class Stored>
__global__ void __launch_bounds__(places_per_block)
    placed_closest_kernel(const SceneView<Stored> scene, const __grid_constant__ PlacedView<Stored> placed,
                          const void* const places, const RayFormat format, const RayFilters filters,
                          const PlacedFilters placed_filters, const std::uint64_t count,
                          const RayResults results) {
  const std::uint64_t i = std::uint64_t{blockIdx.x} * places_per_block + threadIdx.x;
  if (i < count)
    write_closest(scene, placed_ray(placed, filters, placed_filters, i), places, format, filters, results, i);
}

} // namespace

KernelSize launch_closest(const DeviceFiles& files, const RayList& places, const RayResults& results,
                          const RaysRequest&, Counts*, cudaStream_t stream, cudaEvent_t begun) {
  return files.with_store([&]<class Stored>(const DeviceFilesOf<Stored>& stored) {
    const std::uint32_t blocks = blocks_of(places_per_block, places.count);
    const auto start = [&](auto* kernel, const auto&... given) {
      const KernelSize size = stored.kernels->of(kernel, places_per_block).size;
      if (begun != nullptr) check(cudaEventRecord(begun, stream));
      launch(kernel, blocks, places_per_block, stream, stored.scene.view, given..., places.count, results);
      return size;
    };
    if (stored.placements == nullptr)
      return start(closest_kernel<Stored>, stored.on_device(any_structure<Stored>(stored.structure.records)),
                   places.rays, places.format, places.filters);
    check_closest(stored.placements->arrays.bounds);
    return start(placed_closest_kernel<Stored>, stored.placements->arrays.view(), places.rays, places.format,
                 places.filters, places.placed_filters);
  });
}

} // namespace masu
