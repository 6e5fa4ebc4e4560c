#include "renderer/rays/automatic_loop.h"

#include "libscene/geometry/random_rays.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace masu {
namespace {

constexpr std::size_t rays_per_warp = 32, warps_sampled = 64;

// Warps' worth of neighbours, all over the list: at places i · φ modulo 1, which are as far from each other
// as can be, and aren't in step with a picture's rows.
std::vector<std::uint8_t> sample_of(const RayList& rays) {
  const std::size_t size = rays.format.bytes_per_ray(), warps = rays.count / rays_per_warp;
  const std::size_t taken = std::min(warps, warps_sampled);
  std::vector<std::uint8_t> sample(taken * rays_per_warp * size);
  for (std::size_t i = 0; i < taken; ++i) {
    const auto place =
        warps <= warps_sampled
            ? i
            : static_cast<std::size_t>(std::fmod(static_cast<double>(i) * std::numbers::phi, 1) *
                                       static_cast<double>(warps));
    std::memcpy(sample.data() + i * rays_per_warp * size,
                static_cast<const std::uint8_t*>(rays.rays) + place * rays_per_warp * size,
                rays_per_warp * size);
  }
  return sample;
}

// Relative to the scene's origin: in tiles of 8 × 4, a warp each, evenly over the picture.
std::vector<Ray<double>> camera_sample(const SceneFile& scene) {
  constexpr std::int32_t tiles_across = 8, tiles_down = 8, tile_width = 8, tile_height = 4;
  const Camera camera = relative_to(scene.origin(), scene.camera());
  const auto rays = camera_rays<double>(camera, Sampling::centers, false);
  std::vector<Ray<double>> sample;
  for (std::int32_t tile = 0; tile < tiles_across * tiles_down; ++tile) {
    const std::int32_t column = (2 * (tile % tiles_across) + 1) * camera.width / (2 * tiles_across);
    const std::int32_t row = (2 * (tile / tiles_across) + 1) * camera.height / (2 * tiles_down);
    for (std::int32_t i = 0; i < tile_width * tile_height; ++i)
      sample.push_back(camera_ray(rays, column + i % tile_width, row + i / tile_width));
  }
  return sample;
}

// Likewise.
std::vector<Ray<double>> random_sample(const SceneFile& scene) {
  const Sphere<double> sphere = sphere_around(scene.bounds());
  std::vector<Ray<double>> sample;
  for (std::size_t i = 0; i < warps_sampled * rays_per_warp; ++i) {
    RandomSequence random(1, i);
    sample.push_back(random_ray<double>(sphere, random));
  }
  return sample;
}

} // namespace

WarpCosts warp_costs(const ResidentTracer& tracer, const RayList& rays, Query query, Precision precision) {
  const std::vector<std::uint8_t> bytes = sample_of(rays);
  const std::size_t count = bytes.size() / rays.format.bytes_per_ray(), warps = count / rays_per_warp;
  if (count == 0) return {};
  std::vector<std::uint32_t> cells(count), tests(count);
  std::vector<std::uint8_t> occluded(query == Query::occlusion ? count : 0);
  RayResults results;
  results.occluded = occluded.data();
  results.costs = {cells.data(), tests.data()};
  RaysRequest request;
  request.tracing.precision = precision;
  request.query = query;
  tracer.trace(RayList(bytes.data(), count, rays.format), results, request);
  WarpCosts costs;
  for (std::size_t warp = 0; warp < warps; ++warp) {
    std::uint32_t most_work = 0, most_tests = 0;
    for (std::size_t i = warp * rays_per_warp; i < (warp + 1) * rays_per_warp; ++i) {
      costs.work += cells[i] + tests[i];
      costs.tests += tests[i];
      most_work = std::max(most_work, cells[i] + tests[i]);
      most_tests = std::max(most_tests, tests[i]);
    }
    costs.most_work += most_work;
    costs.most_tests += most_tests;
  }
  costs.work /= static_cast<double>(count);
  costs.tests /= static_cast<double>(count);
  costs.most_work /= static_cast<double>(warps);
  costs.most_tests /= static_cast<double>(warps);
  return costs;
}

// A warp's threads wait for its longest ray. Where that costs less than fetching rays does, which was
// measured to take about as long as 2.7 steps and tests, nothing is fetched. Nor is it where rays are so
// alike that few of them wait. But their tests are shared if most threads would wait for those of a few: also
// where such warps are few, since a sample seldom meets the longest rays, for which alone a launch goes on.
// Rays that end at any hit are done at different times however alike they are: for these all that counts is
// how long the others wait. docs/algorithm.md says how near to the best loop's rate that comes.
RayLoop automatic_loop(const WarpCosts& costs, Query query) {
  constexpr double alike = 2.2, fetching = 2.7, is_long = 30;
  const double waiting = costs.most_work - costs.work, more_tests = costs.most_tests - costs.tests;
  const bool any_hit = query == Query::occlusion, wait = waiting >= fetching;
  if (wait && (any_hit ? waiting > is_long : costs.most_work > alike * costs.work))
    return RayLoop::warp_refill;
  const bool share = more_tests > std::max(1.2, 0.7 * costs.tests) || (any_hit && wait);
  return share ? RayLoop::warp : RayLoop::thread_per_ray;
}

RayLoop UsualLoops::of(const ResidentTracer& tracer, bool coherent) {
  if (tracer.is_hierarchy()) return RayLoop::automatic;
  std::atomic<RayLoop>& loop = usual[coherent];
  if (loop == RayLoop::automatic)
    loop = automatic_loop(tracer,
                          relative(coherent ? camera_sample(tracer.scene()) : random_sample(tracer.scene())),
                          Query::nearest_hit, Precision::automatic);
  return loop;
}

} // namespace masu
