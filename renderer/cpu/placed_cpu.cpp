// Rays through placed meshes on the CPU.
#include "renderer/cpu/traced_lists.h"
#include "renderer/rays/closest_points.h"
#include "renderer/rays/placed_rays.h"
#include "renderer/tracer/placed_tracer.h"

namespace masu {
namespace {

template <class Stored>
struct PlacedList {
  const PlacedView<Stored>& placed;
  const RayList& rays;
};
template <class Stored>
PlacedRay<Stored> seen_by(const PlacedList<Stored>& list, std::size_t i) {
  return placed_ray(list.placed, list.rays.filters, list.rays.placed_filters, i);
}
template <class Stored>
std::uint64_t tests_each(const SceneView<Stored>& scene, const PlacedList<Stored>& list) {
  return list.placed.is_brute_force ? scene.primitive_count() : 0;
}

template <class M, class Stored>
void trace(const SceneView<Stored>& scene, const PlacedList<Stored>& list, const RayResults& results,
           const RaysRequest& request, QueryReport& report) {
  using Real = typename M::Real;
  const RayList& rays = list.rays;
  RayList unfiltered = rays; // of triangles by masks: their meshes are entered by what sees them
  if (M::kinds == with_triangles) unfiltered.filters.ray_masks = unfiltered.filters.object_masks = nullptr;
  if (!needs_hits_in_order(unfiltered, results, request))
    return with_query(request.query, [&]<Query query>(QueryTag<query>) {
      trace<query, M>(scene, list, rays, results, request.progress, report, NoCounts{});
    });
  const HitRules rules = hit_rules(request);
  for_each_in_list(rays, request, tests_each(scene, list), [&](std::size_t i) {
    const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
    write_hits<M>(scene, seen_by(list, i), ray.ray, rays.filters, rules, results, i);
    to_list(ray.skipped, rays.format.origin, results, i * rules.row(), rules.row());
  });
}

template <class Stored>
void find_closest(const SceneView<Stored>& scene, const PlacedList<Stored>& list, const RayResults& results,
                  const RaysRequest& request) {
  const RayList& places = list.rays;
  for_each_in_list(places, request, tests_each(scene, list), [&](std::size_t i) {
    write_closest(scene, seen_by(list, i), places.rays, places.format, places.filters, results, i);
  });
}

template <class Stored>
void query(const PlacedArrays<TbbExecutor, Stored>& arrays, const RayList& rays, const RayResults& results,
           const RaysRequest& request, QueryReport& report) {
  const SceneView<Stored> scene = arrays.scene();
  const PlacedView<Stored> placed = arrays.view();
  const PlacedList<Stored> list{placed, rays};
  if (request.query == Query::closest_point) {
    check_closest(arrays.bounds);
    return find_closest(scene, list, results, request);
  }
  with_arithmetic(scene, request.tracing.precision, [&]<class TestRay>(Arithmetic<TestRay>) {
    if constexpr (!std::is_same_v<TestRay, TextbookRay>)
      scene.sphere_count + scene.cone_count == 0
          ? trace<Method<TestRay, with_triangles>>(scene, list, results, request, report)
          : trace<Method<TestRay, with_all_kinds>>(scene, list, results, request, report);
  });
}

} // namespace

QueryReport trace_placed_cpu(const AnyPlacedOnHost& any, const RayList& rays, const RayResults& results,
                             const RaysRequest& request) {
  QueryReport report;
  report.seconds.trace = seconds_of([&] {
    std::visit([&](const auto& host) { query(host.arrays, rays, results, request, report); }, any);
  });
  return report;
}

} // namespace masu
