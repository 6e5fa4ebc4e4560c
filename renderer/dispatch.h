// From what a scene holds and a request says to the code compiled for it.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libgrid/trace/trace.h"
#include "libscene/geometry/textbook.h"
#include "libscene/scene_view.h"
#include "renderer/counts.h"
#include "renderer/render_pixel.h"
#include "renderer/tracing_rules.h"

#include <optional>
#include <type_traits>

namespace masu {

// The ray of an arithmetic, as a type.
template <class TestRay>
using Arithmetic = std::type_identity<TestRay>;

// Calls act(Arithmetic) with the precision's ray; `precision` is resolved.
template <class Stored, class Act>
void with_arithmetic(const SceneView<Stored>&, Precision precision, const Act& act) {
  if constexpr (std::is_same_v<Stored, float>) {
    if (precision == Precision::fast) return act(Arithmetic<TextbookRay>{});
    if (precision != Precision::doubled) return act(Arithmetic<WatertightRay<float>>{});
  }
  act(Arithmetic<WatertightRay<double>>{});
}

// Calls act(SceneView of the scene's own store, Arithmetic). Throws Error(usage) as resolved() does.
template <class Act>
void with_store_and_arithmetic(const SceneFile& scene, Precision precision, const Act& act) {
  precision = resolved(precision, scene);
  scene.with_view([&](const auto& view) {
    with_arithmetic(view, precision, [&](auto arithmetic) { act(view, arithmetic); });
  });
}

// The kinds of primitives that a scene holds.
template <class Stored>
unsigned kinds_in(const SceneView<Stored>& scene, bool has_tapers) {
  return (scene.triangle_count > 0 ? with_triangles : 0) | (scene.sphere_count > 0 ? with_spheres : 0) |
         (scene.cone_count > 0 ? with_cones : 0) | (has_tapers ? with_tapers : 0);
}

template <class View>
inline constexpr bool is_hierarchy = false;
template <class Real>
inline constexpr bool is_hierarchy<HierarchyView<Real>> = true;
template <class Real, class Stored>
inline constexpr bool is_hierarchy<LeafHierarchyView<Real, Stored>> = true;

// A structure's records where they are traced, in host or device memory; none for brute force.
using TracedRecords = std::optional<StructureRecords>;
inline TracedRecords records_of(const StructureFile* structure) {
  return structure != nullptr ? TracedRecords(structure->records()) : std::nullopt;
}
template <class Real>
AnyStructure<Real> any_structure(const TracedRecords& records) {
  return records ? any_structure<Real>(*records) : AnyStructure<Real>{};
}

// Whether what rays visit and test is counted: by brute force it always is.
inline bool is_counted(const TracedRecords& records, const TracingRules& rules) {
  return rules.count || !records;
}

// Returns act(view of the records, Method, Counts or NoCounts) for rays of one arithmetic through a scene of
// that store. What is for use has the code for its structure (GridView, MergedGridView or HierarchyView) and
// for the narrowest set of kinds compiled that holds the scene's; what is for comparison, counting, brute
// force and StopRule::first_cell, shares that for AnyStructure and all kinds.
//
// What the set saves on an H200 over the code for all kinds, in a picture's time: triangles alone 9 %
// (teapot; `double` 8), triangles and spheres 6 to 12 % (balls, mount; `double` 11 to 16), cones that are all
// cylinders 5 % (rings, `robust`).
template <class TestRay, class Stored, class Act>
auto with_method(const TracedRecords& records, const TracingRules& rules, const Act& act) {
  using Real = typename TestRay::Real;
  using General = Method<TestRay, with_all_kinds>;
  const auto with_any = [&] {
    AnyStructure<Real> any = any_structure<Real>(records);
    any.stop = rules.stop;
    return is_counted(records, rules) ? act(any, General{}, Counts{}) : act(any, General{}, NoCounts{});
  };
  const auto with_view = [&]<class View>(const View& view) {
    // Not for each arithmetic: `fast` is compared with, and so are uniform grids by `double`; scenes of
    // doubles are rare.
    if constexpr (!std::is_same_v<TestRay, TextbookRay> && std::is_same_v<Stored, float> &&
                  !std::is_same_v<View, GridView<double>>) {
      const unsigned kinds = rules.general ? with_all_kinds : rules.kinds;
      if ((kinds & ~with_triangles) == 0) return act(view, Method<TestRay, with_triangles>{}, NoCounts{});
      if ((kinds & with_cones) == 0)
        return act(view, Method<TestRay, with_triangles | with_spheres>{}, NoCounts{});
      if constexpr (std::is_same_v<TestRay, WatertightRay<float>>)
        if ((kinds & with_tapers) == 0)
          return act(view, Method<TestRay, with_all_kinds & ~with_tapers>{}, NoCounts{});
      return act(view, General{}, NoCounts{});
    } else {
      return with_any();
    }
  };
  if (is_counted(records, rules) || rules.stop == StopRule::first_cell) return with_any();
  if (records->is_hierarchy) return with_view(hierarchy_view_of<Real>(*records));
  return records->is_merged ? with_view(merged_view_of<Real>(*records)) : with_view(view_of<Real>(*records));
}

// A query as a type.
template <Query query>
using QueryTag = std::integral_constant<Query, query>;
// Calls act(QueryTag).
template <class Act>
void with_query(Query query, const Act& act) {
  query == Query::nearest_hit ? act(QueryTag<Query::nearest_hit>{}) : act(QueryTag<Query::occlusion>{});
}

} // namespace masu
