#include "renderer/cuda/rendering.h"
#include "tools/bench/screen_division/screen_division.h"

namespace masu {
namespace {

using M = OnDevice<Method<WatertightRay<float>, with_all_kinds>>;

// The next tile of a block: from left.end on there is none. `next` counts the tiles that all blocks have
// fetched, where they fetch. Threads share what is left: they have no registers to spare.
__device__ std::uint32_t next_tile_of_block(TileRun& left, std::uint32_t* const next) {
  __shared__ std::uint32_t tile;
  __syncthreads(); // `left` is there, and all have read the last tile
  if (threadIdx.x == 0 && threadIdx.y == 0) {
    tile = next != nullptr ? atomicAdd(next, 1U) : left.first;
    left.first += left.step;
  }
  __syncthreads();
  return tile;
}

template <class Structure>
__global__ void __launch_bounds__(division_tile_side* division_tile_side,
                                  resident_threads_wanted<M> / (division_tile_side * division_tile_side))
    divided_kernel(const SceneView<float> scene, const Lighting<float> lighting, const Structure grid,
                   const CameraRays<float> rays, const RenderRules rules, const Tiles tiles,
                   const ScreenDivision division, std::uint32_t* const next_tile, Vec3f* const colors) {
  __shared__ TileRun left;
  if (threadIdx.x == 0 && threadIdx.y == 0) left = run_of(division, blockIdx.x, gridDim.x, tiles.count);
  NoCounts counts;
  for (std::uint32_t tile = next_tile_of_block(left, next_tile); tile < left.end;
       tile = next_tile_of_block(left, next_tile)) {
    const auto column = static_cast<std::int32_t>(tile % tiles.columns * division_tile_side + threadIdx.x);
    const auto row = static_cast<std::int32_t>(tile / tiles.columns * division_tile_side + threadIdx.y);
    if (column >= rays.columns || row >= rays.rows) continue;
    HitRecord hit{};
    colors[static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.columns) +
           static_cast<std::size_t>(column)] =
        radiance<M>(scene, lighting, grid, rules, camera_ray(rays, column, row), hit, counts);
  }
}

} // namespace

DividedFrame render_divided_cuda(const SceneFile& scene, const StructureFile& grid,
                                 const FrameRequest& request, ScreenDivision division, int workers_each) {
  DividedFrame divided{picture_frame(request), 0};
  Frame& frame = divided.frame;
  const MemoryPool pool;
  Transfer upload(pool);
  const DeviceFilesOf<float> files(scene, &grid, pool, upload); // which the host has checked
  upload.run();
  const DeviceArray<Vec3f> colors(frame.radiance.size());
  const DeviceArray<std::uint32_t> next_tile(1);
  check(cudaMemset(next_tile.data(), 0, sizeof(std::uint32_t)));
  const auto rays =
      camera_rays<float>(relative_to(scene.origin(), request.camera), request.sampling, request.hither);
  const Tiles tiles = tiles_of(frame.columns, frame.rows);
  const auto render = [&]<class View>(const View& view) {
    auto* const kernel = divided_kernel<View>;
    divided.workers =
        std::min(tiles.count, resident_blocks(kernel, division_tile_side * division_tile_side, workers_each));
    frame.kernel = load(kernel);
    const DeviceTimer timer;
    launch(kernel, divided.workers, dim3(division_tile_side, division_tile_side), nullptr, files.scene.view,
           files.scene.lighting, view, rays, request.rules, tiles, division,
           division == ScreenDivision::persistent ? next_tile.data() : nullptr, colors.data());
    frame.seconds.trace = timer.seconds();
  };
  const StructureRecords& records = *files.structure.records;
  records.is_merged ? render(merged_view_of<float>(records)) : render(view_of<float>(records));
  colors.download(frame.radiance.data());
  return divided;
}

} // namespace masu
