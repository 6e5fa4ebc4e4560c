// From what a scene holds and a job asks for to the code compiled for it.
#pragma once

#include "renderer/arithmetic.h"
#include "renderer/render_pixel.h"
#include "renderer/tracer.h"

#include <algorithm>
#include <span>
#include <type_traits>

namespace masu {

// A set of kinds as a type.
template <unsigned kinds_>
struct Kinds {
  static constexpr unsigned kinds = kinds_;
};

// The kinds of primitives that a scene holds.
template <class Stored>
unsigned kinds_in(const SceneView<Stored>& scene, bool has_tapers) {
  return (scene.triangle_count > 0 ? with_triangles : 0) | (scene.sphere_count > 0 ? with_spheres : 0) |
         (scene.cone_count > 0 ? with_cones : 0) | (has_tapers ? with_tapers : 0);
}
// Of one in the host's memory.
template <class Stored>
unsigned kinds_in(const SceneView<Stored>& scene) {
  return kinds_in(scene, std::ranges::any_of(std::span(scene.cones, scene.cone_count), tapers<Stored>));
}

// Calls act(Kinds) with the narrowest set compiled that holds the scene's. What it saves on an H200 over the
// code for all kinds, in a picture's time: triangles alone 9 % (teapot; `fast` 9, `double` 8), triangles and
// spheres 6 to 12 % (balls, mount; `double` 11 to 16, `fast` less than 5: it has none), cones that are all
// cylinders 5 % (rings, `robust`). Scenes of doubles are rare: they have the code for all kinds alone.
template <class TestRay, class Stored, class Act>
void with_kinds(unsigned kinds, const Act& act) {
  if constexpr (std::is_same_v<Stored, float>) {
    if ((kinds & ~with_triangles) == 0) return act(Kinds<with_triangles>{});
    if constexpr (!std::is_same_v<TestRay, TextbookRay>)
      if ((kinds & with_cones) == 0) return act(Kinds<with_triangles | with_spheres>{});
    if constexpr (std::is_same_v<TestRay, WatertightRay<float>>)
      if ((kinds & with_tapers) == 0) return act(Kinds<with_all_kinds & ~with_tapers>{});
  }
  act(Kinds<with_all_kinds>{});
}

template <class View>
inline constexpr bool is_hierarchy = false;
template <class Real>
inline constexpr bool is_hierarchy<HierarchyView<Real>> = true;
template <class Real, class Stored>
inline constexpr bool is_hierarchy<LeafHierarchyView<Real, Stored>> = true;

// Calls act(GridView, MergedGridView, HierarchyView or NoGrid, Method, Counts or NoCounts) for rays of one
// arithmetic: what a job needs, and no more. Counting, brute force and StopRule::first_cell run the code for
// all kinds.
template <class TestRay, class Stored, class Act>
void with_method(const SceneView<Stored>&, const GridFile* grid, const TracingRules& rules, const Act& act) {
  using Real = typename TestRay::Real;
  using General = Method<TestRay, with_all_kinds>;
  if (grid == nullptr) return act(NoGrid{}, General{}, Counts{});
  const auto with_view = [&](const auto& view) {
    if constexpr (!is_hierarchy<std::decay_t<decltype(view)>>) {
      if (rules.stop == StopRule::first_cell) {
        using Study = Method<TestRay, with_all_kinds, StopRule::first_cell>;
        return rules.count ? act(view, Study{}, Counts{}) : act(view, Study{}, NoCounts{});
      }
    }
    if (rules.count) return act(view, General{}, Counts{});
    if (rules.general) return act(view, General{}, NoCounts{});
    with_kinds<TestRay, Stored>(
        rules.kinds, [&]<unsigned kinds>(Kinds<kinds>) { act(view, Method<TestRay, kinds>{}, NoCounts{}); });
  };
  if (grid->is_hierarchy()) return with_view(grid->hierarchy_view<Real>());
  grid->is_merged() ? with_view(grid->merged_view<Real>()) : with_view(grid->view<Real>());
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
