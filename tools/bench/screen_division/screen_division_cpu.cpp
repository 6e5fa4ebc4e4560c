#include "libscene/base/stopwatch.h"
#include "renderer/dispatch.h"
#include "tools/bench/screen_division/screen_division.h"
#include "tools/common/cli.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace masu {
namespace {

using M = Method<WatertightRay<float>, with_all_kinds>;

template <class Structure>
void render_tiles(const SceneView<float>& scene, const Lighting<float>& lighting, const Structure& grid,
                  const FrameRequest& request, const CameraRays<float>& rays, ScreenDivision division,
                  std::uint32_t worker, std::atomic<std::uint32_t>& fetched, DividedFrame& divided) {
  Frame& frame = divided.frame;
  const Tiles tiles = tiles_of(frame.columns, frame.rows);
  const TileRun run = run_of(division, worker, divided.workers, tiles.count);
  const bool fetches = division == ScreenDivision::persistent;
  NoCounts counts;
  for (std::uint32_t tile = fetches ? fetched++ : run.first; tile < run.end;
       tile = fetches ? fetched++ : tile + run.step) {
    const auto column = static_cast<std::int32_t>(tile % tiles.columns) * division_tile_side,
               row = static_cast<std::int32_t>(tile / tiles.columns) * division_tile_side;
    for (std::int32_t y = row; y < std::min(row + division_tile_side, frame.rows); ++y) {
      for (std::int32_t x = column; x < std::min(column + division_tile_side, frame.columns); ++x) {
        HitRecord hit{};
        frame.radiance[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.columns) +
                       static_cast<std::size_t>(x)] =
            radiance<M>(scene, lighting, grid, request.rules, camera_ray(rays, x, y), hit, counts);
      }
    }
  }
}

} // namespace

DividedFrame render_divided_cpu(const SceneFile& scene, const StructureFile& grid,
                                const FrameRequest& request, ScreenDivision division, int workers_each) {
  const std::size_t threads = allowed_threads();
  DividedFrame divided{
      picture_frame(request),
      static_cast<std::uint32_t>(threads * static_cast<std::size_t>(std::max(workers_each, 1)))};
  const auto rays =
      camera_rays<float>(relative_to(scene.origin(), request.camera), request.sampling, request.hither);
  const auto view = scene.view<float>();
  const auto lighting = scene.lighting<float>();
  const auto render = [&](const auto& accelerator) {
    std::atomic<std::uint32_t> fetched{0};
    const Stopwatch watch;
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, divided.workers),
        [&](const auto& range) {
          for (std::uint32_t worker = range.begin(); worker != range.end(); ++worker)
            render_tiles(view, lighting, accelerator, request, rays, division, worker, fetched, divided);
        },
        tbb::static_partitioner());
    divided.frame.seconds.trace = watch.seconds();
  };
  grid.is_merged() ? render(merged_view_of<float>(grid.records())) : render(view_of<float>(grid.records()));
  return divided;
}

} // namespace masu
