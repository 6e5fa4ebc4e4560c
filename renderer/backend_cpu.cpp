#include "libscene/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"

#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <functional>

namespace masu {
namespace {

constexpr std::int32_t task_side = 32; // rays: neighbours share cells in cache
constexpr std::size_t rays_a_task = 4096;

void add(Counts& total, const Counts& part) {
  total += part;
}
void add(Counts&, const NoCounts&) {}

// Calls render(first column, its end, first row, its end) for the tiles that the worker takes.
template <class Render>
void render_tiles(const Frame& frame, Schedule schedule, std::uint32_t worker,
                  std::atomic<std::uint32_t>& fetched, const Render& render) {
  const Tiles tiles = tiles_of(frame.columns, frame.rows);
  const TileRun run = run_of(schedule, worker, frame.workers, tiles.count);
  const bool fetches = schedule == Schedule::persistent;
  for (std::uint32_t tile = fetches ? fetched++ : run.first; tile < run.end;
       tile = fetches ? fetched++ : tile + run.step) {
    const auto column = static_cast<std::int32_t>(tile % tiles.columns) * tile_side,
               row = static_cast<std::int32_t>(tile / tiles.columns) * tile_side;
    render(column, std::min(column + tile_side, frame.columns), row, std::min(row + tile_side, frame.rows));
  }
}

template <class M, class Stored, class Grid, class C>
void render(const SceneView<Stored>& scene, const Grid& grid, const FrameRequest& request, Frame& frame,
            const C&) {
  const auto rays = camera_rays<typename M::Real>(request.camera, request.sampling, request.hither);
  tbb::combinable<Counts> totals;
  const auto render_rays = [&](std::int32_t first_column, std::int32_t end_column, std::int32_t first_row,
                               std::int32_t end_row) {
    C counts;
    for (std::int32_t row = first_row; row != end_row; ++row) {
      for (std::int32_t column = first_column; column != end_column; ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                        static_cast<std::size_t>(column);
        HitRecord hit{};
        frame.radiance[at] =
            radiance<M>(scene, grid, request.rules, camera_ray(rays, column, row), hit, counts);
        if (request.hits) frame.hits[at] = hit;
      }
    }
    add(totals.local(), counts);
  };
  if (request.schedule == Schedule::hardware) {
    tbb::parallel_for(
        tbb::blocked_range2d<std::int32_t>(0, frame.rows, task_side, 0, frame.columns, task_side),
        [&](const auto& range) {
          render_rays(range.cols().begin(), range.cols().end(), range.rows().begin(), range.rows().end());
        });
  } else {
    std::atomic<std::uint32_t> fetched{0};
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, frame.workers),
        [&](const auto& range) {
          for (std::uint32_t worker = range.begin(); worker != range.end(); ++worker)
            render_tiles(frame, request.schedule, worker, fetched, render_rays);
        },
        tbb::static_partitioner());
  }
  totals.combine_each([&](const Counts& part) { frame.counts += part; });
}

template <Query query, class M, class Stored, class Grid, class C>
void trace(const SceneView<Stored>& scene, const Grid& grid, const RaysRequest& request, RayHits& result,
           const C&) {
  tbb::combinable<Counts> totals;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, request.rays.size(), rays_a_task),
                    [&](const auto& range) {
                      C counts;
                      for (std::size_t i = range.begin(); i != range.end(); ++i)
                        result.hits[i] = trace_listed<query, M>(
                            scene, grid, typed<typename M::Real>(request.rays[i]), request.hit_name, counts);
                      add(totals.local(), counts);
                    });
  totals.combine_each([&](const Counts& part) { result.counts += part; });
}

template <class Act>
double seconds_of(const Act& act) {
  const Stopwatch watch;
  act();
  return watch.seconds();
}

// Seconds of act(), the median of so many, after some that don't count.
template <class Act>
double timed(int warm_up, int repeat, const Act& act) {
  for (int i = 0; i < warm_up; ++i)
    act();
  std::vector<double> seconds(static_cast<std::size_t>(repeat));
  for (double& one : seconds)
    one = seconds_of(act);
  return median(std::move(seconds));
}

// Calls act(SceneView, grid's view, Method, counts).
template <class Act>
void with_everything(const SceneFile& scene, const GridFile* grid, const TracingRules& rules,
                     const Act& act) {
  with_store_and_arithmetic(
      scene, rules.precision, [&]<class TestRay>(const auto& view, Arithmetic<TestRay>) {
        with_method<TestRay>(view, grid, rules, [&](const auto& accelerator, auto method, auto counts) {
          act(view, accelerator, method, counts);
        });
      });
}

} // namespace

Frame render_cpu(const SceneFile& scene, const GridFile* grid, const FrameRequest& request) {
  Frame frame = empty_frame(request);
  const std::size_t threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int each = request.schedule == Schedule::hardware ? 1 : std::max(request.workers_each, 1);
  frame.workers = static_cast<std::uint32_t>(threads * static_cast<std::size_t>(each));
  frame.seconds.upload = seconds_of(request.before_tracing);
  with_everything(
      scene, grid, request.tracing, [&]<class M>(const auto& view, const auto& accelerator, M, auto counts) {
        frame.seconds.trace = timed(request.warm_up, request.repeat,
                                    [&] { render<M>(view, accelerator, request, frame, counts); });
      });
  return frame;
}

RayHits trace_rays_cpu(const SceneFile& scene, const GridFile* grid, const RaysRequest& request) {
  RayHits result;
  result.hits.resize(request.rays.size());
  result.seconds.upload = seconds_of(request.before_tracing);
  with_everything(
      scene, grid, request.tracing, [&]<class M>(const auto& view, const auto& accelerator, M, auto counts) {
        with_query(request.query, [&]<Query query>(Asked<query>) {
          result.seconds.trace = timed(request.warm_up, request.repeat,
                                       [&] { trace<query, M>(view, accelerator, request, result, counts); });
        });
      });
  return result;
}

} // namespace masu
