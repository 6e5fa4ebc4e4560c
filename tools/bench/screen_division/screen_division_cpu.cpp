#include "libscene/base/stopwatch.h"
#include "renderer/dispatch.h"
#include "tools/bench/screen_division/screen_division.h"
#include "tools/common/cli.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace masu {

DividedFrame render_divided_cpu(const SceneFile& scene, const StructureFile& grid,
                                const FrameRequest& request, ScreenDivision division, int workers_each) {
  using M = Method<WatertightRay<float>, with_all_kinds>;
  const std::size_t threads = allowed_threads();
  DividedFrame divided{
      picture_frame(request),
      static_cast<std::uint32_t>(threads * static_cast<std::size_t>(std::max(workers_each, 1)))};
  const auto rays =
      camera_rays<float>(relative_to(scene.origin(), request.camera), request.sampling, request.hither);
  const auto view = scene.view<float>();
  const auto lighting = scene.lighting<float>();
  Frame& frame = divided.frame;
  const Tiles tiles = tiles_of(frame.columns, frame.rows);
  const bool fetches = division == ScreenDivision::persistent;
  const auto render = [&](const auto& accelerator) {
    std::atomic<std::uint32_t> fetched{0};
    const auto render_tiles = [&](std::uint32_t worker) {
      const TileRun run = run_of(division, worker, divided.workers, tiles.count);
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
                radiance<M>(view, lighting, accelerator, request.rules, camera_ray(rays, x, y), hit, counts);
          }
        }
      }
    };
    const Stopwatch watch;
    tbb::parallel_for(std::uint32_t{0}, divided.workers, render_tiles, tbb::static_partitioner());
    frame.seconds.trace = watch.seconds();
  };
  grid.is_merged() ? render(merged_view_of<float>(grid.records())) : render(view_of<float>(grid.records()));
  return divided;
}

} // namespace masu
