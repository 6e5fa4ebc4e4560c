// Rays through placed meshes on the CPU.
#include "libscene/base/stopwatch.h"
#include "renderer/arithmetic.h"
#include "renderer/dispatch.h"
#include "renderer/rays/closest_points.h"
#include "renderer/rays/list_progress.h"
#include "renderer/rays/placed_rays.h"
#include "renderer/tracer/placed_tracer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace masu {
namespace {

template <class M, class Stored>
void trace(const PlacedOnHost<Stored>& host, const RayList& rays, const RayResults& results,
           const RaysRequest& request) {
  using Real = typename M::Real;
  const SceneView<Stored> scene = host.arrays.scene();
  const PlacedView<Stored> placed = host.arrays.view();
  const HitRules rules = hit_rules(request);
  const bool in_order = needs_hits_in_order(rays, results, request);
  ListProgress progress(request.progress, rays.count, 16,
                        placed.is_brute_force ? scene.primitive_count() : 0);
  const auto trace_ray = [&](std::size_t i) {
    progress.done(i);
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
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.count, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i)
      trace_ray(i);
  });
}

template <class Stored>
void find_closest(const PlacedOnHost<Stored>& host, const RayList& places, const RayResults& results,
                  const std::function<void(double)>& report_progress) {
  check_closest(host.arrays.bounds);
  const SceneView<Stored> scene = host.arrays.scene();
  const PlacedView<Stored> placed = host.arrays.view();
  ListProgress progress(report_progress, places.count, 16,
                        placed.is_brute_force ? scene.primitive_count() : 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.count, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      write_closest(scene, placed_ray(placed, places.filters, places.placed_filters, i), places.rays,
                    places.format, places.filters, results, i);
      progress.done(i);
    }
  });
}

} // namespace

template <class Stored>
QueryReport trace_placed_cpu(const PlacedOnHost<Stored>& host, const RayList& rays, const RayResults& results,
                             const RaysRequest& request) {
  QueryReport report;
  const Stopwatch watch;
  const bool triangles_alone = host.scene->beside->primitive_count() == 0;
  const auto trace_as = [&]<class TestRay>(Arithmetic<TestRay>) {
    triangles_alone ? trace<Method<TestRay, with_triangles>>(host, rays, results, request)
                    : trace<Method<TestRay, with_all_kinds>>(host, rays, results, request);
  };
  if (request.query == Query::closest_point) {
    find_closest(host, rays, results, request.progress);
  } else if constexpr (sizeof(Stored) == sizeof(float)) {
    if (request.tracing.precision != Precision::doubled)
      trace_as(Arithmetic<WatertightRay<float>>{});
    else
      trace_as(Arithmetic<WatertightRay<double>>{});
  } else {
    trace_as(Arithmetic<WatertightRay<double>>{});
  }
  report.seconds.trace = watch.seconds();
  return report;
}
template QueryReport trace_placed_cpu(const PlacedOnHost<float>&, const RayList&, const RayResults&,
                                      const RaysRequest&);
template QueryReport trace_placed_cpu(const PlacedOnHost<double>&, const RayList&, const RayResults&,
                                      const RaysRequest&);

} // namespace masu
