#include "renderer/cpu/on_cpu.h"

#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <atomic>

namespace masu {
namespace {

constexpr std::int32_t task_side = 32; // rays: neighbours share cells in cache

template <class M, class Stored, class Grid, class C>
void render(const SceneView<Stored>& scene, const Grid& grid, const FrameRequest& request, Frame& frame,
            const C&) {
  const auto rays =
      camera_rays<typename M::Real>(request.camera, request.sampling, request.hither, request.window);
  tbb::combinable<Counts> totals;
  std::atomic<std::size_t> traced = 0;
  const double rays_in_all = static_cast<double>(frame.columns) * frame.rows;
  const std::int32_t counted_rows = frame.rows - (request.count_last_row ? 0 : 1);
  const auto render_rays = [&](std::int32_t first_column, std::int32_t end_column, std::int32_t first_row,
                               std::int32_t end_row) {
    C counts;
    const RayResults attributes = attribute_results(frame.objects.data(), frame.normals.data());
    const RayCosts costs = costs_of(frame);
    for (std::int32_t row = first_row; row != end_row; ++row) {
      for (std::int32_t column = first_column; column != end_column; ++column) {
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                        static_cast<std::size_t>(column);
        HitRecord hit{};
        C ray_counts;
        const Ray<typename M::Real> ray = camera_ray(rays, column, row);
        const Vec3f light = radiance<M>(scene, grid, request.rules, ray, hit, ray_counts);
        if (request.shaded) frame.radiance[at] = light;
        if (request.hits) frame.hits[at] = hit;
        if (request.attributes) write_attributes(scene, ray, listed(hit), attributes, at);
        write_costs(costs, at, ray_counts);
        if (row < counted_rows) add(counts, ray_counts);
      }
    }
    add(totals.local(), counts);
    if (!request.progress) return;
    const std::size_t count =
        static_cast<std::size_t>(end_column - first_column) * static_cast<std::size_t>(end_row - first_row);
    request.progress(static_cast<double>(traced += count) / rays_in_all);
  };
  tbb::parallel_for(tbb::blocked_range2d<std::int32_t>(0, frame.rows, task_side, 0, frame.columns, task_side),
                    [&](const auto& range) {
                      render_rays(range.cols().begin(), range.cols().end(), range.rows().begin(),
                                  range.rows().end());
                    });
  totals.combine_each([&](const Counts& part) { frame.counts += part; });
}

} // namespace

void render_cpu(const SceneFile& scene, const GridFile* grid, const FrameRequest& request, Frame& frame) {
  with_everything(
      scene, grid, request.tracing, [&]<class M>(const auto& view, const auto& accelerator, M, auto counts) {
        frame.seconds.trace = seconds_of([&] { render<M>(view, accelerator, request, frame, counts); });
      });
}

} // namespace masu
