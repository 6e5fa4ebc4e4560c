#include "renderer/cpu/traced_lists.h"
#include "renderer/rays/closest_points.h"

namespace masu {
namespace {

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
