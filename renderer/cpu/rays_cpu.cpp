#include "renderer/cpu/on_cpu.h"
#include "renderer/rays/closest_points.h"
#ifdef MASU_HOST_AVX2
#include "renderer/cpu/packet_lists.h"
#endif

#include <tbb/parallel_reduce.h>

namespace masu {
namespace {

constexpr std::size_t rays_per_task = 4096;

// Traces as many rays from `first` on as can be several at a time; returns the first one left.
template <Query query, class M, class Stored, class Structure, class C>
std::size_t
trace_in_lanes([[maybe_unused]] const SceneView<Stored>& scene, [[maybe_unused]] const Structure& structure,
               [[maybe_unused]] const RayList& rays, [[maybe_unused]] const RayResults& results,
               [[maybe_unused]] ListProgress& progress, std::size_t first, [[maybe_unused]] std::size_t end) {
#ifdef MASU_HOST_AVX2
  using Real = typename M::Real;
  if constexpr (std::is_same_v<typename M::TestRay, WatertightRay<Real>> && !C::is_counted &&
                (!is_any_structure<Structure> || std::is_same_v<Stored, double>)) {
    const auto found = [&](std::size_t i, const ListedHit<Real>& listed) __attribute__((always_inline)) {
      progress.done(i);
      const Hit<float> hit = reported(listed);
      write_hit<query>(results, i, hit);
      if (query != Query::nearest_hit || (hit.primitive == no_primitive && !results.has_attributes())) return;
      if (!results.has_attributes() && !may_be_rounded<Real>(rays.format)) return;
      const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
      if (results.has_attributes()) write_attributes(scene, NoStructure{}, ray.ray, hit, results, i);
      to_list(ray.skipped, rays.format.origin, results, i, 1);
    };
    const auto by_list = [&]<class Tests>(Tests, const HierarchyView<Real>& hierarchy) {
      return trace_list<query, Tests>(scene, hierarchy, rays.rays, rays.format, first, end, found);
    };
    if constexpr (is_any_structure<Structure>) { // no code is compiled for its structure and kinds alone
      if (structure.form != StructureForm::hierarchy) return first;
      return scene.primitive_count() == scene.triangle_count
                 ? by_list(Method<typename M::TestRay, with_triangles>{}, structure.hierarchy)
                 : by_list(M{}, structure.hierarchy);
    } else if constexpr (std::is_same_v<Structure, HierarchyView<Real>>)
      return by_list(M{}, structure);
    else
      return trace_in_turn<query, M>(scene, structure, rays.rays, rays.format, first, end, found);
  }
#endif
  return first;
}

template <Query query, class M, class Stored, class Structure, class C>
void trace(const SceneView<Stored>& scene, const Structure& structure, const RayList& rays,
           const RayResults& results, const std::function<void(double)>& report_progress, QueryReport& report,
           const C&) {
  using Real = typename M::Real;
  ListProgress progress(report_progress, rays.count, 256,
                        std::is_same_v<Structure, NoStructure> ? scene.primitive_count() : 0);
  const auto trace_some = [&](const tbb::blocked_range<std::size_t>& range, Counts counts) {
    for (std::size_t i = trace_in_lanes<query, M, Stored, Structure, C>(scene, structure, rays, results,
                                                                        progress, range.begin(), range.end());
         i != range.end(); ++i) {
      progress.done(i);
      const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
      C ray_counts;
      const Hit<float> hit = trace_listed<query, M>(scene, structure, ray.ray, ray_counts);
      write_hit<query>(results, i, hit);
      write_costs(results.costs, i, ray_counts);
      add(counts, ray_counts);
      if (query != Query::nearest_hit) continue;
      if (results.has_attributes()) write_attributes(scene, NoStructure{}, ray.ray, hit, results, i);
      to_list(ray.skipped, rays.format.origin, results, i, 1);
    }
    return counts;
  };
  const tbb::blocked_range<std::size_t> all(0, rays.count, rays_per_task);
  report.counts = all.is_divisible() ? tbb::parallel_reduce(all, Counts{}, trace_some,
                                                            [](Counts a, const Counts& b) { return a += b; })
                                     : trace_some(all, {}); // without what TBB takes for a call of one ray
}

// Of hits in order: through any structure, of any kind.
template <class TestRay, class Stored>
void list_hits(const SceneView<Stored>& scene, const StructureFile* structure, const RayList& rays,
               const RayResults& results, const RaysRequest& request) {
  using Real = typename TestRay::Real;
  const HitRules rules = hit_rules(request);
  const AnyStructure<Real> view = any_structure<Real>(records_of(structure));
  for_each_in_list(rays, request, structure == nullptr ? scene.primitive_count() : 0, [&](std::size_t i) {
    const ListedRay<Real> ray = listed_ray<Real>(rays.rays, rays.format, i, scene.clip);
    write_hits<Method<TestRay, with_all_kinds>>(scene, view, ray.ray, rays.filters, rules, results, i);
    to_list(ray.skipped, rays.format.origin, results, i * rules.row(), rules.row());
  });
}

void find_closest(const SceneFile& scene, const StructureFile* hierarchy, const RayList& places,
                  const RayResults& results, const RaysRequest& request) {
  const auto search = [&](const auto& view, const auto& structure) {
    for_each_in_list(places, request, hierarchy == nullptr ? view.primitive_count() : 0, [&](std::size_t i) {
      write_closest(view, structure, places.rays, places.format, places.filters, results, i);
    });
  };
  scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
    hierarchy == nullptr ? search(view, NoStructure{}) : search(view, hierarchy->hierarchy_view<Stored>());
  });
}

} // namespace

QueryReport trace_rays_cpu(const SceneFile& scene, const StructureFile* structure, const RayList& rays,
                           const RayResults& results, const RaysRequest& request) {
  QueryReport report;
  if (request.query == Query::closest_point) {
    report.seconds.trace = seconds_of([&] { find_closest(scene, structure, rays, results, request); });
    return report;
  }
  if (needs_hits_in_order(rays, results, request)) {
    with_store_and_arithmetic(
        scene, request.tracing.precision, [&]<class TestRay>(const auto& view, Arithmetic<TestRay>) {
          if constexpr (!std::is_same_v<TestRay, TextbookRay>)
            report.seconds.trace =
                seconds_of([&] { list_hits<TestRay>(view, structure, rays, results, request); });
        });
    return report;
  }
  with_everything(scene, structure, request.tracing,
                  [&]<class M>(const auto& view, const auto& accelerator, M, auto counts) {
                    with_query(request.query, [&]<Query query>(QueryTag<query>) {
                      report.seconds.trace = seconds_of([&] {
                        trace<query, M>(view, accelerator, rays, results, request.progress, report, counts);
                      });
                    });
                  });
  return report;
}

} // namespace masu
