// Rays through placed meshes on the CPU.
#include "renderer/cpu/traced_lists.h"
#include "renderer/rays/placed_rays.h"
#include "renderer/tracer/placed_tracer.h"

namespace masu {
namespace {

template <class Stored>
std::uint64_t tests_each(const SceneView<Stored>& scene, const PlacedList<Stored>& list) {
  return list.placed.is_brute_force ? scene.primitive_count() : 0;
}

template <class M, class Stored>
void trace(const SceneView<Stored>& scene, const PlacedList<Stored>& list, const RayList& rays,
           const RayResults& results, const RaysRequest& request, QueryReport& report) {
  RayList unfiltered = rays; // of triangles by masks: their meshes are entered by what sees them
  if (M::kinds == with_triangles) unfiltered.filters.ray_masks = unfiltered.filters.object_masks = nullptr;
  if (!needs_hits_in_order(unfiltered, results, request))
    return with_query(request.query, [&]<Query query>(QueryTag<query>) {
      trace<query, M>(scene, list, rays, results, request.progress, report, NoCounts{});
    });
  list_hits<M>(scene, list, tests_each(scene, list), rays, results, request);
}

template <class Stored>
void query(const PlacedArrays<TbbExecutor, Stored>& arrays, const RayList& rays, const RayResults& results,
           const RaysRequest& request, QueryReport& report) {
  const SceneView<Stored> scene = arrays.scene();
  const PlacedList<Stored> list{arrays.view(), rays.filters};
  if (request.query == Query::closest_point) {
    check_closest(arrays.bounds);
    return find_closest(scene, list, rays, results, request);
  }
  with_arithmetic(scene, request.tracing.precision, [&]<class TestRay>(Arithmetic<TestRay>) {
    if constexpr (!std::is_same_v<TestRay, TextbookRay>)
      scene.sphere_count + scene.cone_count == 0
          ? trace<Method<TestRay, with_triangles>>(scene, list, rays, results, request, report)
          : trace<Method<TestRay, with_all_kinds>>(scene, list, rays, results, request, report);
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
