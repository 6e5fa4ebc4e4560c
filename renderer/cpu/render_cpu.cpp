#include "renderer/cpu/on_cpu.h"
#ifdef MASU_HOST_AVX2
#include "renderer/cpu/pixel_lists.h"
#endif

#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <functional>

namespace masu {
namespace {

using Tile = tbb::blocked_range2d<std::int32_t>;

constexpr std::int32_t task_side = 32; // rays: neighbours share cells in cache

void for_each_tile(const FrameRequest& request, const Frame& frame,
                   const std::function<void(const Tile&)>& render_tile) {
  std::atomic<std::size_t> traced = 0;
  const double rays_in_all = static_cast<double>(frame.columns) * frame.rows;
  tbb::parallel_for(Tile(0, frame.rows, task_side, 0, frame.columns, task_side), [&](const Tile& tile) {
    render_tile(tile);
    if (request.progress)
      request.progress(static_cast<double>(traced += tile.rows().size() * tile.cols().size()) / rays_in_all);
  });
}

// Calls act(column, row) for the pixels of a tile, those of 8 by 4 together (packet.h).
template <class Act>
void for_each_pixel(const Tile& tile, const Act& act) {
  for (std::int32_t y = tile.rows().begin(); y < tile.rows().end(); y += 4) {
    for (std::int32_t x = tile.cols().begin(); x < tile.cols().end(); x += 8) {
      for (std::int32_t row = y; row < std::min(y + 4, tile.rows().end()); ++row)
        for (std::int32_t column = x; column < std::min(x + 8, tile.cols().end()); ++column)
          act(column, row);
    }
  }
}

// What a pixel's camera ray is, and where what it sees goes.
template <class Real, class Stored>
struct Pixels {
  const SceneView<Stored>& scene;
  const Lighting<Stored>& lighting;
  const FrameRequest& request;
  Frame& frame;
  CameraRays<Real> rays = camera_rays<Real>(request.camera, request.sampling, request.hither, request.window);
  RayResults attributes = attribute_results(frame.objects.data(), frame.normals.data());

  std::size_t index(std::int32_t column, std::int32_t row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
           static_cast<std::size_t>(column);
  }
  Ray<Real> ray(std::int32_t column, std::int32_t row) const { return camera_ray(rays, column, row); }
  void write(std::int32_t column, std::int32_t row, const Vec3f& light, const HitRecord& hit) const {
    const std::size_t at = index(column, row);
    if (request.shaded) frame.radiance[at] = light;
    if (request.hits) frame.hits[at] = hit;
    if (request.attributes)
      write_attributes(scene, NoStructure{}, ray(column, row), {hit.t, static_cast<PrimitiveIndex>(hit.name)},
                       attributes, at);
  }
};

template <class M, class Stored, class Structure, class C>
void render_one_by_one(const Pixels<typename M::Real, Stored>& pixels, const Structure& structure, const C&) {
  const FrameRequest& request = pixels.request;
  Frame& frame = pixels.frame;
  tbb::combinable<Counts> totals;
  const RayCosts costs = request.costs ? RayCosts{frame.cells.data(), frame.tests.data()} : RayCosts{};
  const std::int32_t counted_rows = frame.rows - (request.count_last_row ? 0 : 1);
  for_each_tile(request, frame, [&](const Tile& tile) {
    C counts;
    for_each_pixel(tile, [&](std::int32_t column, std::int32_t row) {
      HitRecord hit{};
      C ray_counts;
      const Vec3f light = radiance<M>(pixels.scene, pixels.lighting, structure, request.rules,
                                      pixels.ray(column, row), hit, ray_counts);
      pixels.write(column, row, light, hit);
      write_costs(costs, pixels.index(column, row), ray_counts);
      if (row < counted_rows) add(counts, ray_counts);
    });
    add(totals.local(), counts);
  });
  totals.combine_each([&](const Counts& part) { frame.counts += part; });
}

#ifdef MASU_HOST_AVX2
template <class M, class Stored>
void render_by_lists(const Pixels<typename M::Real, Stored>& pixels,
                     const HierarchyView<typename M::Real>& hierarchy) {
  tbb::enumerable_thread_specific<PixelLists<M, Stored>> all_lists(
      [&] { return PixelLists<M, Stored>(pixels.scene, pixels.lighting, hierarchy, pixels.request.rules); });
  for_each_tile(pixels.request, pixels.frame, [&](const Tile& tile) {
    PixelLists<M, Stored>& lists = all_lists.local();
    lists.pixels.clear();
    for_each_pixel(tile, [&](std::int32_t column, std::int32_t row) {
      lists.pixels.emplace_back(pixels.ray(column, row));
    });
    lists.follow_all();
    std::size_t i = 0;
    for_each_pixel(tile, [&](std::int32_t column, std::int32_t row) {
      pixels.write(column, row, lists.pixels[i].tree.light, lists.pixels[i].first_hit);
      ++i;
    });
  });
}
#endif

template <class M, class Stored, class Structure, class C>
void render(const SceneView<Stored>& scene, const Lighting<Stored>& lighting, const Structure& structure,
            const FrameRequest& request, Frame& frame, const C& counts) {
  const Pixels<typename M::Real, Stored> pixels{scene, lighting, request, frame};
#ifdef MASU_HOST_AVX2
  // Spheres and cones are tested one at a time either way, and rings' pictures would take 5 % longer.
  if constexpr (tests_triangles_in_lanes<M, Stored> && is_hierarchy<Structure> && !C::is_counted) {
    render_by_lists<M>(pixels, structure);
  } else
#endif
    render_one_by_one<M>(pixels, structure, counts);
}

} // namespace

void render_cpu(const SceneFile& scene, const StructureFile* structure, const FrameRequest& request,
                Frame& frame) {
  with_everything(
      scene, structure, request.tracing,
      [&]<class M, class Stored>(const SceneView<Stored>& view, const auto& accelerator, M, auto counts) {
        const Lighting<Stored> lighting = scene.lighting<Stored>();
        frame.seconds.trace =
            seconds_of([&] { render<M>(view, lighting, accelerator, request, frame, counts); });
      });
}

} // namespace masu
