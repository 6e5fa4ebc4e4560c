#include "renderer/cpu/traced_lists.h"

namespace masu {

QueryReport trace_rays_cpu(const SceneFile& scene, const StructureFile* structure, const RayList& rays,
                           const RayResults& results, const RaysRequest& request) {
  QueryReport report;
  report.seconds.trace = seconds_of([&] {
    if (request.query == Query::closest_point)
      return scene.with_view([&]<class Stored>(const SceneView<Stored>& view) {
        structure == nullptr
            ? find_closest(view, NoStructure{}, rays, results, request)
            : find_closest(view, hierarchy_view_of<Stored>(structure->records()), rays, results, request);
      });
    if (needs_hits_in_order(rays, results, request)) // through any structure, of any kind
      return with_store_and_arithmetic(
          scene, request.tracing.precision, [&]<class TestRay>(const auto& view, Arithmetic<TestRay>) {
            if constexpr (!std::is_same_v<TestRay, TextbookRay>)
              list_hits<Method<TestRay, with_all_kinds>>(
                  view, any_structure<typename TestRay::Real>(records_of(structure)),
                  structure == nullptr ? view.primitive_count() : 0, rays, results, request);
          });
    with_everything(scene, structure, request.tracing,
                    [&]<class M>(const auto& view, const auto& accelerator, M, auto counts) {
                      with_query(request.query, [&]<Query query>(QueryTag<query>) {
                        trace<query, M>(view, accelerator, rays, results, request.progress, report, counts);
                      });
                    });
  });
  return report;
}

} // namespace masu
