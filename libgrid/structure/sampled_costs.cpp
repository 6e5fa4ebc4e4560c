#include "libgrid/structure/sampled_costs.h"

#include "libgrid/file/structure_file.h"
#include "libgrid/structure/unit_costs.h"
#include "libgrid/trace/trace.h"
#include "libscene/base/parallel.h"
#include "libscene/geometry/random_rays.h"
#include "libscene/geometry/surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <vector>

namespace masu {
namespace {

struct StepCounts {
  static constexpr bool is_counted = true;
  std::uint64_t steps = 0, tests = 0;

  void triangle_test() { ++tests; }
  void sphere_test() { ++tests; }
  void cone_test() { ++tests; }
  void cell(bool /*empty*/) { ++steps; }
  void skipped(std::int32_t /*voxels*/) {}
};

struct Traced {
  StepCounts counts;
  std::optional<Ray<double>> scattered; // where anything is hit
};

template <class Stored, class View>
Traced trace(const SceneView<Stored>& scene, const View& view, const Ray<double>& ray,
             RandomSequence& random) {
  Traced traced;
  const auto near =
      nearest_hit_near<Method<WatertightRay<double>, with_all_kinds>>(scene, view, ray, traced.counts);
  if (near.hit.primitive == no_primitive) return traced;
  const SurfacePoint<double> point = surface_at<with_all_kinds>(scene, near);
  const Vec3d direction = random_diffuse_direction(facing(point, ray.direction).normal, random);
  traced.scattered = unbounded_ray(leaving(point, direction), direction);
  return traced;
}

// Between two random points of the sphere; of unit length at any scale, unlike random_ray().
Ray<double> ray_across(const Sphere<double>& sphere, RandomSequence& random) {
  const Vec3d from = random_direction(random), to = random_direction(random);
  return unbounded_ray(fma(from, sphere.radius, sphere.center), normalized(to - from));
}

Vec3d random_point(const Boxd& box, RandomSequence& random) {
  const Vec3d at{random.uniform(), random.uniform(), random.uniform()}, size = box.max - box.min;
  return {fma(at.x, size.x, box.min.x), fma(at.y, size.y, box.min.y), fma(at.z, size.z, box.min.z)};
}

// From a random point within the bounds towards one of a random primitive's box.
template <class Stored>
Ray<double> aimed_ray(const SceneView<Stored>& scene, const Boxd& bounds_of_all, RandomSequence& random) {
  const auto primitive =
      static_cast<PrimitiveIndex>(random.uniform() * static_cast<double>(scene.primitive_count()));
  const Vec3d from = random_point(bounds_of_all, random);
  Vec3d to = from;
  with_primitive(scene, primitive, [&](const auto& aim) { to = random_point(bounds(aim), random); });
  return unbounded_ray(from, normalized(to - from));
}

RayCost mean(const std::vector<StepCounts>& counts, std::size_t rays) {
  std::uint64_t steps = 0, tests = 0; // whole numbers: any order gives the same sum
  for (const StepCounts& count : counts) {
    steps += count.steps;
    tests += count.tests;
  }
  const auto n = static_cast<double>(std::max<std::size_t>(rays, 1));
  return {static_cast<double>(steps) / n, static_cast<double>(tests) / n};
}

template <class Stored, class View>
SampledCosts costs_through(const SceneView<Stored>& scene, const View& view, const SampleLimits& limits,
                           const ProgressMonitor* progress) {
  const Boxd space = cast<double>(scene.clip);
  const Sphere<double> sphere = sphere_around(space);
  std::vector<StepCounts> across(limits.rays), aimed(limits.rays), scattered(limits.rays);
  std::atomic<std::size_t> hits = 0;
  const auto trace_one = [&](std::size_t i) {
    if (i % 16 == 0) check_progress(progress);
    RandomSequence random(1, i);
    across[i] = trace(scene, view, ray_across(sphere, random), random).counts;
    const Traced first = trace(scene, view, aimed_ray(scene, space, random), random);
    aimed[i] = first.counts;
    if (!first.scattered) return;
    ++hits;
    scattered[i] = trace(scene, view, *first.scattered, random).counts;
  };
  // Twice as many each time: few where a single ray takes long.
  SampledCosts costs;
  while (costs.rays < limits.rays && costs.work <= limits.work) {
    const std::size_t end = std::min(limits.rays, std::max<std::size_t>(16, 2 * costs.rays));
    parallel_for(end - costs.rays, [&](std::size_t i) { trace_one(costs.rays + i); });
    for (std::size_t& i = costs.rays; i != end; ++i) {
      for (const StepCounts& counts : {across[i], aimed[i], scattered[i]})
        costs.work += counts.steps + counts.tests;
    }
  }
  costs.across = mean(across, costs.rays);
  costs.aimed = mean(aimed, costs.rays);
  costs.scattered = mean(scattered, hits);
  return costs;
}

} // namespace

template <class Stored>
SampledCosts sampled_costs(const SceneView<Stored>& scene, const Structure& grid, const SampleLimits& limits,
                           const ProgressMonitor* progress) {
  SampledCosts costs;
  if (scene.primitive_count() == 0) return costs;
  with_structure_view<double>(
      grid, [&](const auto& view) { costs = costs_through(scene, view, limits, progress); });
  return costs;
}
template SampledCosts sampled_costs(const SceneView<float>&, const Structure&, const SampleLimits&,
                                    const ProgressMonitor*);
template SampledCosts sampled_costs(const SceneView<double>&, const Structure&, const SampleLimits&,
                                    const ProgressMonitor*);

// As expected_time() has it, the geometric mean of the sets: 8.9 tests in rings in triangles, which take a
// grid, and from 2.2 to 6.3 in fifteen other scenes of the SPD (docs/algorithm.md).
bool grid_may_win(const SampledCosts& hierarchy) {
  return std::cbrt(hierarchy.across.tests * hierarchy.aimed.tests * hierarchy.scattered.tests) > 7.5;
}

double expected_time(const SampledCosts& costs, StructureKind kind, Processor processor) {
  const UnitCosts unit = unit_costs(kind, processor);
  double product = 1;
  for (const RayCost& ray : {costs.across, costs.aimed, costs.scattered})
    product *= unit.step * ray.steps + unit.test * ray.tests;
  return std::cbrt(product);
}

} // namespace masu
