// Rays through placed meshes on the CPU.
#include "renderer/cpu/on_cpu.h"
#include "renderer/rays/closest_points.h"
#include "renderer/rays/placed_rays.h"
#include "renderer/tracer/placed_tracer.h"

namespace masu {
namespace {

template <class Stored>
std::uint64_t tests_each(const PlacedView<Stored>& placed, const SceneView<Stored>& scene) {
  return placed.is_brute_force ? scene.primitive_count() : 0;
}

template <class M, class Stored>
void trace(const SceneView<Stored>& scene, const PlacedView<Stored>& placed, const RayList& rays,
           const RayResults& results, const RaysRequest& request) {
  using Real = typename M::Real;
  const HitRules rules = hit_rules(request);
  const bool in_order = needs_hits_in_order(rays, results, request);
  for_each_in_list(rays, request, tests_each(placed, scene), [&](std::size_t i) {
    const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
    const PlacedRay<Stored> seen = placed_ray(placed, rays.filters, rays.placed_filters, i);
    if (in_order) {
      write_hits<M>(scene, seen, ray.ray, rays.filters, rules, results, i);
    } else {
      with_query(request.query, [&]<Query query>(QueryTag<query>) {
        NoCounts counts;
        const Hit<float> hit = trace_listed<query, M>(scene, seen, ray.ray, counts);
        write_hit<query>(results, i, hit);
        if (query == Query::nearest_hit) write_named(scene, seen, ray.ray, hit, results, i);
      });
    }
    if (request.query != Query::occlusion)
      to_list(ray.skipped, rays.format.origin, results, i * rules.row(), rules.row());
  });
}

template <class Stored>
void find_closest(const SceneView<Stored>& scene, const PlacedView<Stored>& placed, const RayList& places,
                  const RayResults& results, const RaysRequest& request) {
  for_each_in_list(places, request, tests_each(placed, scene), [&](std::size_t i) {
    write_closest(scene, placed_ray(placed, places.filters, places.placed_filters, i), places.rays,
                  places.format, places.filters, results, i);
  });
}

template <class Stored>
void query(const PlacedArrays<TbbExecutor, Stored>& arrays, const RayList& rays, const RayResults& results,
           const RaysRequest& request) {
  const SceneView<Stored> scene = arrays.scene();
  const PlacedView<Stored> placed = arrays.view();
  if (request.query == Query::closest_point) {
    check_closest(arrays.bounds);
    return find_closest(scene, placed, rays, results, request);
  }
  with_arithmetic(scene, request.tracing.precision, [&]<class TestRay>(Arithmetic<TestRay>) {
    if constexpr (!std::is_same_v<TestRay, TextbookRay>)
      scene.sphere_count + scene.cone_count == 0
          ? trace<Method<TestRay, with_triangles>>(scene, placed, rays, results, request)
          : trace<Method<TestRay, with_all_kinds>>(scene, placed, rays, results, request);
  });
}

} // namespace

QueryReport trace_placed_cpu(const AnyPlacedOnHost& any, const RayList& rays, const RayResults& results,
                             const RaysRequest& request) {
  QueryReport report;
  report.seconds.trace = seconds_of(
      [&] { std::visit([&](const auto& host) { query(host.arrays, rays, results, request); }, any); });
  return report;
}

} // namespace masu
