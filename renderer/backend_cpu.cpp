#include "libscene/stopwatch.h"
#include "renderer/backend.h"
#include "renderer/dispatch.h"

#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <functional>

namespace masu {
namespace {

constexpr std::int32_t tile = 32; // pixels a side: neighbours share cells in cache
constexpr std::size_t rays_a_task = 4096;

void add(Counts& total, const Counts& part) {
  total += part;
}
void add(Counts&, const NoCounts&) {}

template <class M, class Grid, class C>
void render(const SceneView<typename M::Stored>& scene, const Grid& grid, const FrameRequest& request,
            Frame& frame, const C&) {
  const auto rays = eye_rays<typename M::Real>(request.camera, request.sampling, request.hither);
  tbb::combinable<Counts> totals;
  tbb::parallel_for(
      tbb::blocked_range2d<std::int32_t>(0, frame.rows, tile, 0, frame.columns, tile),
      [&](const auto& range) {
        C counts;
        for (std::int32_t row = range.rows().begin(); row != range.rows().end(); ++row) {
          for (std::int32_t column = range.cols().begin(); column != range.cols().end(); ++column) {
            const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                            static_cast<std::size_t>(column);
            EyeHit hit{};
            frame.radiance[at] =
                radiance<M>(scene, grid, request.rules, eye_ray(rays, column, row), hit, counts);
            if (request.hits) frame.hits[at] = hit;
          }
        }
        add(totals.local(), counts);
      });
  totals.combine_each([&](const Counts& part) { frame.counts += part; });
}

template <Question question, class M, class Grid, class C>
void trace(const SceneView<typename M::Stored>& scene, const Grid& grid, const RaysRequest& request,
           RayHits& result, const C&) {
  tbb::combinable<Counts> totals;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, request.rays.size(), rays_a_task), [&](const auto& range) {
        C counts;
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          result.hits[i] = trace_listed<question, M>(scene, grid, request.rays[i], request.hit_name, counts);
        add(totals.local(), counts);
      });
  totals.combine_each([&](const Counts& part) { result.counts += part; });
}

// Seconds of act(), the median of so many, after some that don't count.
template <class Act>
double timed(int warm_up, int repeat, const Act& act) {
  for (int i = 0; i < warm_up; ++i)
    act();
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const Stopwatch watch;
    act();
    seconds.push_back(watch.seconds());
  }
  return median(std::move(seconds));
}

// Calls act(SceneView) with the scene's own store.
template <class Act>
void with_store(const SceneFile& scene, const Act& act) {
  scene.is_float64() ? act(scene.view<double>()) : act(scene.view<float>());
}

} // namespace

Frame render_cpu(const SceneFile& scene, const GridFile* grid, const FrameRequest& request) {
  Frame frame = empty_frame(request);
  frame.seconds.trace = timed(0, request.repeat, [&] {
    with_store(scene, [&](const auto& view) {
      with_everything(view, grid, ForPictures{secondary_of(scene.table())}, request.count,
                      [&](const auto& accelerator, auto model, auto counts) {
                        render<decltype(model)>(view, accelerator, request, frame, counts);
                      });
    });
  });
  return frame;
}

RayHits trace_rays_cpu(const SceneFile& scene, const GridFile* grid, const RaysRequest& request) {
  RayHits result;
  result.hits.resize(request.rays.size());
  with_store(scene, [&](const auto& view) {
    with_everything(view, grid, ForHits{}, request.count,
                    [&]<class M, class C>(const auto& accelerator, M, C counts) {
                      with_question(request.question, [&]<Question question>(Asked<question>) {
                        result.seconds.trace = timed(request.warm_up, request.repeat, [&] {
                          trace<question, M>(view, accelerator, request, result, counts);
                        });
                      });
                    });
  });
  return result;
}

} // namespace masu
